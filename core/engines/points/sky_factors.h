#pragma once

#include <cstdint>
#include <vector>

#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/tree_shade.h"
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

/// The days of a year on which the same crowns are in leaf.
struct LeafTime {
    std::vector<std::uint8_t> inLeaf;  ///< by Crown::season
    double share = 0;                  ///< of the year's days
};

/// What the crowns of a city's trees take of the sky's light. Trees that lose their leaves take the mean of
/// the days of a year with leaves and without.
class SkyCrowns {
public:
    /// All trees of the city, also those to the north. O(trees)
    explicit SkyCrowns(const City& city);

    /// Of the sky component of a point (SkyFactors::skyComponentPct), percent of the sky: what crowns take
    /// in the part that nothing solid hides. By half degrees of azimuth and altitude: crowns of 10 deg to
    /// 0.02 % of the sky. Some ns for each crown of the city, 20 ns for each crown and direction through
    /// it, and, where trees have leaf days of their own, some ns for each such direction and LeafTime.
    [[nodiscard]] double takenPct(const SkyPoint& point, const Skyline& skyline) const {
        return taken(point, skyline, TreeColumns::seasonal).skyComponentPct;
    }
    /// The same of both factors. Evergreen: every tree in leaf all year.
    [[nodiscard]] SkyFactors taken(const SkyPoint& point, const Skyline& skyline, TreeColumns column) const;

private:
    std::vector<Crown> crowns_;
    std::vector<LeafTime> year_, alwaysInLeaf_;
};

}  // namespace noonmark
