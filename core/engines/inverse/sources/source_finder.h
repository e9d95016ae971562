#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "core/engines/inverse/lane_sources.h"
#include "core/engines/inverse/lanes.h"

namespace noonmark {

/// For RunRule::steepestM: walls up to 75 degrees off the sun's way count as one surface. Wider, and two
/// walls of one building that stand behind each other would, too.
inline float computeSteepestRise(glm::dvec3 towardsSun, double cellM) {
    const double rise = towardsSun.z / std::max(1e-9, std::hypot(towardsSun.x, towardsSun.y));
    return float(4 * cellM * rise);
}

/// What throws a shadow at one instant, found block by block of lanes.
class SourceInstant {
public:
    virtual ~SourceInstant() = default;
    /// Writes a block of the lanes into one of `sources`, which has its size already. Places beyond the grid
    /// have no sources. May run for several blocks at a time; one core a block, some tenths of a millisecond.
    virtual void fill(int block, LaneSources& sources, int into) const = 0;
};

/// Finds what throws a shadow on the cells of a flat grid (z = 0).
class SourceFinder {
public:
    virtual ~SourceFinder() = default;
    [[nodiscard]] virtual int levels() const = 0;
    /// `towardsSun`: unit vector, z > 0. `lanes`: over the finder's grid. Both outlive what is returned.
    [[nodiscard]] virtual std::unique_ptr<SourceInstant> at(glm::dvec3 towardsSun,
                                                            const Lanes& lanes) const = 0;
    /// Rays that one instant costs; 0 where none are traced.
    [[nodiscard]] virtual std::uint64_t raysAnInstant() const = 0;
};

}  // namespace noonmark
