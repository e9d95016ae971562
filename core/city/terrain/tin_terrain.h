#pragma once

#include <cstddef>
#include <optional>

#include "core/city/meshes/mesh.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

struct TinTerrain {
    Terrain terrain;
    std::size_t filled = 0;  ///< cells that no triangle covers, filled from the nearest cell
};

/// Rasterises a triangulated ground to a grid over its box. Cell size: half the mean distance of its points,
/// 0.5 to 100 m, larger if the grid would exceed 16 million cells. Where triangles overlap the highest
/// counts. Nothing if no cell lies under a triangle.
std::optional<TinTerrain> rasterizeTin(const TriangleMesh& tin);

}  // namespace noonmark
