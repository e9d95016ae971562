#pragma once

#include <cstdint>
#include <vector>

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// The edges that a draughtsman would draw: those where two faces meet at more than `angleDeg`, and borders.
/// Two indices of vertices an edge, each edge once. Faces share an edge when they share its vertices by
/// index. O(triangles log triangles).
std::vector<std::uint32_t> findFeatureEdges(const TriangleMesh& mesh, double angleDeg = 20);

}  // namespace noonmark
