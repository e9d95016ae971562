#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/geo/grid.h"

namespace noonmark {

/// A box of places on a grid, in cells.
struct CellBox {
    glm::dvec2 low{1e30};
    glm::dvec2 high{-1e30};
};

/// A plane piece of a building's surface, bounded by edges in any order (even-odd). x and y in cells of a
/// grid, z in metres.
struct SurfaceFacet {
    glm::dvec3 normal{};  ///< outward; normal . point = offset on it
    double offset = 0;
    std::uint32_t firstEdge = 0;  ///< into SurfaceFacets::edges
    std::uint32_t edgeCount = 0;
    std::uint32_t building = 0;  ///< index in City::buildings
    bool convex = false;  ///< one loop that turns one way only: any line crosses it twice or not at all
    /// Who can see it from behind as the first thing of its building: those that start inside, or so close to
    /// the surface that the way in is left out. Empty: nobody.
    CellBox fromBehind;
};

/// The whole surface of some buildings.
struct SurfaceFacets {
    using Edge = std::array<glm::dvec3, 2>;
    std::vector<SurfaceFacet> facets;
    std::vector<Edge> edges;

    [[nodiscard]] std::span<const Edge> edgesOf(const SurfaceFacet& facet) const {
        return std::span(edges).subspan(facet.firstEdge, facet.edgeCount);
    }
};

/// Walls, roofs and undersides of prisms, triangles of meshes, of the buildings with these indices, on flat
/// ground z = 0; what lies below the ground is left out. `nearestHitM`: hits nearer than this will not count,
/// metres.
SurfaceFacets makeSurfaceFacets(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid,
                                double nearestHitM);

}  // namespace noonmark
