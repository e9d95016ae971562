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

/// A box of positions on a grid, in cells.
struct CellBox {
    glm::dvec2 low{1e30};
    glm::dvec2 high{-1e30};
};

/// A plane piece of a building's surface, bounded by edges in any order (even-odd rule). x and y in cells of
/// a grid, z in metres.
struct SurfaceFacet {
    glm::dvec3 normal{};  ///< outward; normal . point = offset on the plane
    double offset = 0;
    std::uint32_t firstEdge = 0;  ///< index in SurfaceFacets::edges
    std::uint32_t edgeCount = 0;
    std::uint32_t building = 0;  ///< index in City::buildings
    bool convex = false;         ///< one loop, turning one way: any line crosses it twice or never
    /// Positions from which a ray may hit this facet from behind before any other of its building: those
    /// inside, or so close to the surface that the entry is ignored. Empty: none.
    CellBox fromBehind;
};

/// The complete surface of some buildings.
struct SurfaceFacets {
    using Edge = std::array<glm::dvec3, 2>;
    std::vector<SurfaceFacet> facets;
    std::vector<Edge> edges;

    [[nodiscard]] std::span<const Edge> edgesOf(const SurfaceFacet& facet) const {
        return std::span(edges).subspan(facet.firstEdge, facet.edgeCount);
    }
};

/// Walls, roofs and undersides of prisms, and triangles of meshes, of the buildings with these indices, on
/// flat ground at z = 0; parts below the ground are left out. `nearestHitM`: closer hits will be ignored,
/// metres.
SurfaceFacets makeSurfaceFacets(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid,
                                double nearestHitM);

}  // namespace noonmark
