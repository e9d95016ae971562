#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace noonmark {

/// A horizon in 16 bits. Its *steepness* is height / (height + distance) = tan / (1 + tan) of its altitude:
/// 0 on the level, 1 straight up, and nearly even in angle. The code is its level of 65,535, rounded down; a
/// sun has the level nearest to its own steepness. So horizons count as they are, and a sun is moved by half
/// a level at most: 0.0005 to 0.0009 deg of altitude, some 0.2 s of time.
using HorizonCode = std::int16_t;

inline constexpr int steepnessLevels = 65'535;
inline constexpr HorizonCode noHorizon = std::numeric_limits<HorizonCode>::min();

/// Steepness 0 to 1, above where it must hide every sun but one in the zenith.
inline HorizonCode toHorizonCode(float steepness) {
    return HorizonCode(std::min(int(steepness * float(steepnessLevels)), steepnessLevels - 1) + noHorizon);
}

/// Of a sun with this tangent of altitude: it is hidden by horizons of a higher code. -32,768 to 32,766.
inline HorizonCode toSunCode(double tan) {
    const double steepness = std::isinf(tan) ? 1 : tan / (1 + tan);
    return HorizonCode(std::clamp(int(std::lround(steepness * steepnessLevels)), 1, steepnessLevels) - 1 +
                       noHorizon);
}

/// No horizon below this steepness hides a sun of this code.
inline float toSteepness(HorizonCode sun) {
    return float(int(sun) - int(noHorizon) + 1) / float(steepnessLevels);
}

/// The tangent of that altitude, and its cotangent.
inline double toTangent(HorizonCode sun) {
    const double steepness = double(toSteepness(sun));
    return steepness / (1 - steepness);
}
inline float toCotangent(HorizonCode sun) { return (1 - toSteepness(sun)) / toSteepness(sun); }

}  // namespace noonmark
