#pragma once

#include "core/engines/points/skyline.h"

namespace noonmark {

/// How much of the sky's light reaches a surface, without reflected light.
struct SkyFactors {
    /// Sky view factor: share of the light that the surface would receive in the open, lying level, under a
    /// sky of equal brightness. An unobstructed level surface has 1, an unobstructed wall 0.5.
    double skyView = 0;
    /// The same under the CIE standard overcast sky, (1 + 2 sin(altitude)) / 3 of the zenith's brightness,
    /// percent. For a wall it is the vertical sky component; an unobstructed wall has 39.6 %.
    double skyComponentPct = 0;
};

/// Integrated in closed form over altitude, and over azimuth by Gauss's rule of five points between the
/// skyline's breaks, at most 1 degree apart. Tests hold the sky view factor below an endless obstruction to
/// 2e-5, that of a court to 5e-4 and that below a balcony to 3e-4: where an overhang's edge crosses another
/// edge between two breaks, the rule is less exact.
SkyFactors computeSkyFactors(const Skyline& skyline);

}  // namespace noonmark
