#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

/// The Delaunay triangulation of points: counter-clockwise triangles of their indices. Of coincident points
/// the first is used. Empty if all points lie on one line. O(points log points). Backend:
/// tin_terrain_cgal.cpp.
std::vector<glm::uvec3> triangulateDelaunay(std::span<const glm::vec2> points);

struct TinTerrain {
    Terrain terrain;
    std::size_t filled = 0;  ///< cells that no triangle covers, filled from the cells around them
};

/// Rasterises a triangulated ground to a grid over its box. Cell size: half the mean distance of its points,
/// 0.5 to 100 m, larger if the grid would exceed 16 million cells. Where triangles overlap the highest
/// counts. Nothing if no cell lies under a triangle.
std::optional<TinTerrain> rasterizeTin(const TriangleMesh& tin);

}  // namespace noonmark
