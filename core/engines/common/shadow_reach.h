#pragma once

#include <cstdint>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Where shadows fall in a period: how far, for each azimuth that the sun visits.
class ShadowReach {
public:
    /// Reads the steps' directions only.
    explicit ShadowReach(const SunSteps& sun);

    /// Whether the shadow of an occluder within `box`, up to `heightM` above the lowest ground of
    /// `receivers`, can touch that box at some step. Never says no wrongly; says yes for some that miss
    /// (boxes for shapes, degrees for azimuths).
    [[nodiscard]] bool touches(const Box2& box, double heightM, const Box2& receivers) const;

private:
    /// The sun's steps within one degree of azimuth.
    struct Bin {
        glm::dvec2 away;        ///< unit vector that shadows run along, at the bin's middle
        double lengthPerMetre;  ///< of the longest shadow: 1 / tan of the lowest altitude
    };
    std::vector<Bin> bins_;  ///< only those visited
    double longest_ = 0;     ///< largest lengthPerMetre
};

/// Indices of the buildings whose shadow can fall on a receiver at some step, ascending. The rest can be left
/// out of any engine without changing its answer. O(cells + buildings x azimuth degrees visited); 43,000
/// buildings take milliseconds.
std::vector<std::uint32_t> findBuildingsInReach(const City& city, const Receivers& receivers,
                                                const SunSteps& sun);

}  // namespace noonmark
