#pragma once

#include "core/accumulate/sources/source_finder.h"
#include "core/accumulate/sources/surface_facets.h"

namespace noonmark {

/// In object order: at one instant each piece of a building's surface throws a polygon on the ground, and the
/// height of the occluding point is linear in it; the nearest few are kept cell by cell. Finds what rays
/// find, to rounding at the polygons' edges, for all cells at once. Cost: some 10 ns a row of a polygon.
class ProjectedSourceFinder final : public SourceFinder {
public:
    ProjectedSourceFinder(SurfaceFacets facets, const Grid& grid, int levels, float nearestHitM);
    void find(glm::dvec3 towardsSun, ShadowSources& sources, const std::stop_token& stop) const override;
    [[nodiscard]] std::uint64_t raysAnInstant() const override { return 0; }

private:
    SurfaceFacets facets_;
    Grid grid_;
    int levels_;
    float nearestHitM_;
};

}  // namespace noonmark
