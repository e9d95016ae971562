#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/engines/projected/casters/shadow_casters.h"

namespace noonmark {

/// What decides how far casters' shadows reach, one entry a caster.
struct CasterExtents {
    std::vector<double> lowX, lowY, highX, highY;  ///< bounds of the points, cells
    std::vector<double> topM;

    void add(const ShadowCaster& caster) {
        lowX.push_back(caster.low.x);
        lowY.push_back(caster.low.y);
        highX.push_back(caster.high.x);
        highY.push_back(caster.high.y);
        topM.push_back(double(caster.topM));
    }
};

/// A test of the extents of casters against a rectangle of cells. All ranges include 0 or a margin, so that
/// only the top of a caster matters.
struct ReachLimits {
    /// A coordinate of a caster, plus an offset for each metre of its top, must touch a range.
    struct Axis {
        double least = 0, most = 0;  ///< offset per metre
        double low = 0, high = 0;    ///< the range
    };
    Axis x, y, across;
    glm::dvec2 acrossUnit{1, 0};  ///< across the mean direction in which shadows fall
};

/// Bit i: caster first + i may touch the rectangle. At most 64 casters. Backend: caster_extents_hwy.cpp.
std::uint64_t findTouching(const CasterExtents& extents, std::size_t first, std::size_t count,
                           const ReachLimits& limits);

}  // namespace noonmark
