#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace noonmark {

/// A horizon in 16 bits. Its *steepness* is height / (height + distance) = tan / (1 + tan) of its altitude: 0
/// if level, 1 if vertical, and nearly uniform in angle. The code is one of 65,535 levels of steepness,
/// rounded down; a sun is rounded to the nearest level. Horizons thus need no rounding of their own, and a
/// sun moves by half a level at most: 0.0004 to 0.0009 deg of altitude, some 0.2 s of time.
using HorizonCode = std::int16_t;

inline constexpr int steepnessLevels = 65'535;
inline constexpr HorizonCode noHorizon = std::numeric_limits<HorizonCode>::min();

/// Code of a steepness from 0 to 1; at 1, the horizon must hide every sun except one in the zenith.
inline HorizonCode toHorizonCode(float steepness) {
    return HorizonCode(std::min(int(steepness * float(steepnessLevels)), steepnessLevels - 1) + noHorizon);
}

/// Code of a sun with this tangent of altitude; horizons of a higher code hide it. -32,768 to 32,766.
inline HorizonCode toSunCode(double tan) {
    const double steepness = std::isinf(tan) ? 1 : tan / (1 + tan);
    return HorizonCode(std::clamp(int(std::lround(steepness * steepnessLevels)), 1, steepnessLevels) - 1 +
                       noHorizon);
}

/// Horizons below this steepness do not hide a sun of this code.
inline float toSteepness(HorizonCode sun) {
    return float(int(sun) - int(noHorizon) + 1) / float(steepnessLevels);
}

/// Tangent of the corresponding altitude, and its cotangent.
inline double toTangent(HorizonCode sun) {
    const double steepness = double(toSteepness(sun));
    return steepness / (1 - steepness);
}
inline float toCotangent(HorizonCode sun) { return (1 - toSteepness(sun)) / toSteepness(sun); }

}  // namespace noonmark
