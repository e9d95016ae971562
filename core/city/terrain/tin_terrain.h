#pragma once

#include <cstddef>
#include <optional>

#include "core/city/meshes/mesh.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

struct TinTerrain {
    Terrain terrain;
    std::size_t filled = 0;  ///< cells that no triangle covers; they have their nearest neighbour's elevation
};

/// A triangulated ground as a grid over its box. Cell size: half the mean distance of its points, 0.5 to 100
/// m, larger where the grid would have more than 16 million cells. Where triangles overlap the highest
/// counts. Nothing when no cell lies under a triangle.
std::optional<TinTerrain> rasterizeTin(const TriangleMesh& tin);

}  // namespace noonmark
