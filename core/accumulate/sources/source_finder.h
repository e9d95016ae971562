#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <stop_token>

#include "core/accumulate/shadow_lines.h"

namespace noonmark {

/// For ShadowSources::steepestM: walls up to 75 degrees off the sun's way count as one surface. Wider, and
/// two walls of one building that stand behind each other would, too.
inline float steepestOnASurface(glm::dvec3 towardsSun, double cellM) {
    const double rise = towardsSun.z / std::max(1e-9, std::hypot(towardsSun.x, towardsSun.y));
    return float(4 * cellM * rise);
}

/// Finds what throws a shadow on the cells of a flat grid (z = 0) at one instant.
class SourceFinder {
public:
    virtual ~SourceFinder() = default;
    /// `towardsSun`: unit vector, z > 0. Reuses the arrays of `sources`. All cores; incomplete after a stop
    /// request.
    virtual void find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) const = 0;
    /// Rays that one instant costs; 0 where none are traced.
    [[nodiscard]] virtual std::uint64_t raysAnInstant() const = 0;
};

}  // namespace noonmark
