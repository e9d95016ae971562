#pragma once

#include <cstdint>
#include <vector>

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// The edges of a line drawing: those where two faces meet at more than `angleDeg`, and borders. Two vertex
/// indices per edge, each edge once. Faces share an edge if they share its vertices by index. O(triangles log
/// triangles).
std::vector<std::uint32_t> findFeatureEdges(const TriangleMesh& mesh, double angleDeg = 20);

}  // namespace noonmark
