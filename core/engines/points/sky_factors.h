#pragma once

#include <vector>

#include "core/city/city.h"
#include "core/engines/api/tree_shade.h"
#include "core/engines/points/skyline.h"
#include "core/engines/trees/crowns.h"

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

/// What the crowns of a city's trees take of the sky's light. Trees that lose their leaves take the mean of
/// the days of a year with leaves and without.
class SkyCrowns {
public:
    /// All trees of the city, also those to the north. O(trees)
    explicit SkyCrowns(const City& city);

    /// Of the sky component of a point (SkyFactors::skyComponentPct), percent of the sky: what crowns take
    /// in the part that nothing solid hides. By half degrees of azimuth and altitude: crowns of 10 deg to
    /// 0.02 % of the sky. Some ns for each crown of the city, and 20 ns for each crown and direction through
    /// it.
    [[nodiscard]] double takenPct(const SkyPoint& point, const Skyline& skyline) const {
        return taken(point, skyline, TreeColumns::seasonal).skyComponentPct;
    }
    /// The same of both factors. Evergreen: every tree in leaf all year.
    [[nodiscard]] SkyFactors taken(const SkyPoint& point, const Skyline& skyline, TreeColumns column) const;

private:
    /// Of the days of one phase; of those in leaf as much as `shareInLeaf`.
    [[nodiscard]] SkyFactors takenIn(const SkyPoint& point, const Skyline& skyline, std::size_t phase,
                                     double shareInLeaf) const;

    std::vector<Crown> crowns_;
    LeafPhases phases_;           // of the days of a year
    std::vector<double> shares_;  // of each phase
    double shareInLeaf_ = 1;      // of the days; 0 where there are phases
};

}  // namespace noonmark
