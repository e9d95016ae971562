#pragma once

#include "core/engines/inverse/sources/source_finder.h"
#include "core/engines/inverse/sources/surface_facets.h"

namespace noonmark {

/// In object order: at one instant each piece of a building's surface throws a polygon on the ground, and the
/// height of the occluding point is linear in it; the nearest few are kept place by place. Finds what rays
/// find, to rounding at the polygons' edges, for all cells at once. Cost: some 10 ns a polygon and 16 cells.
class ProjectedSourceFinder final : public SourceFinder {
public:
    /// `facets` in cells of the grid that lanes will be over.
    ProjectedSourceFinder(SurfaceFacets facets, int levels, float nearestHitM);
    [[nodiscard]] int levels() const override { return levels_; }
    [[nodiscard]] std::unique_ptr<SourceInstant> at(glm::dvec3 towardsSun, const Lanes& lanes) const override;
    [[nodiscard]] std::uint64_t raysAnInstant() const override { return 0; }

private:
    SurfaceFacets facets_;
    int levels_;
    float nearestHitM_;
};

}  // namespace noonmark
