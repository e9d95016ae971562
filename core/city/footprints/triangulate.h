#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// Crossings allowed in a footprint that was not repaired; this many take about 0.1 s.
inline constexpr std::size_t maxMeshCrossings = 10000;

/// A footprint as counter-clockwise triangles.
struct Triangulation {
    std::vector<glm::vec2> points;
    std::vector<glm::uvec3> triangles;  ///< indices into points
    bool tangled =
        false;  ///< more than maxMeshCrossings crossings: no triangles, since it would take too long
};

/// Constrained Delaunay triangulation of the interior. `points` begins with the footprint's own points in
/// order, outer ring first; if rings cross (a footprint that was not repaired), the crossings follow. O(n log
/// n).
Triangulation triangulate(const Footprint& footprint);

}  // namespace noonmark
