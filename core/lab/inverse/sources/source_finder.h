#pragma once

// Finders of shadow sources: the nearest occluders of each cell of flat ground at one instant. SourceFinder
// and SourceInstant (this file) are the interfaces. ProjectedSourceFinder (projected_source_finder.h) fills
// the shadow polygons of surface facets and keeps the nearest levels; RaySourceFinder traces rays.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "core/engines/ray/ray_scene.h"
#include "core/lab/inverse/lanes.h"

namespace noonmark {

/// Value for RunRule::steepestM: walls up to 75 degrees from the sun's azimuth count as one surface. With a
/// larger limit, two walls of one building, one behind the other, would count as one too.
inline float computeSteepestRise(glm::dvec3 towardsSun, double cellM) {
    const double rise = towardsSun.z / std::max(1e-9, std::hypot(towardsSun.x, towardsSun.y));
    return float(4 * cellM * rise);
}

/// The shadow sources at one instant, found block by block of lanes.
class SourceInstant {
public:
    virtual ~SourceInstant() = default;
    /// Writes a block of the lanes to block `into` of `sources`, which already has its size. Positions
    /// outside the grid have no sources. May be called for several blocks concurrently; uses one core per
    /// block, some tenths of a millisecond.
    virtual void fill(int block, LaneSources& sources, int into) const = 0;
};

/// Finds the shadow sources of the cells of a flat grid (z = 0).
class SourceFinder {
public:
    virtual ~SourceFinder() = default;
    [[nodiscard]] virtual int levels() const = 0;
    /// `towardsSun`: unit vector, z > 0. `lanes`: over the finder's grid. The finder and `lanes` must outlive
    /// the result.
    [[nodiscard]] virtual std::unique_ptr<SourceInstant> at(glm::dvec3 towardsSun,
                                                            const Lanes& lanes) const = 0;
    /// Rays traced for one instant; 0 if none.
    [[nodiscard]] virtual std::uint64_t raysAnInstant() const = 0;
};

/// Finds sources with rays, in packets of 16 neighbours (paper, section 5).
class RaySourceFinder final : public SourceFinder {
public:
    RaySourceFinder(RayScene scene, const Grid& grid, int levels, float nearestHitM);
    [[nodiscard]] int levels() const override { return levels_; }
    [[nodiscard]] std::unique_ptr<SourceInstant> at(glm::dvec3 towardsSun, const Lanes& lanes) const override;
    [[nodiscard]] std::uint64_t raysAnInstant() const override { return cells_; }

private:
    RayScene scene_;
    std::uint64_t cells_;
    int levels_;
    float nearestHitM_;
};

}  // namespace noonmark
