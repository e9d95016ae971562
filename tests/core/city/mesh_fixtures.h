#pragma once

#include "core/city/meshes/mesh_topology.h"

namespace noonmark::tests {

/// A closed box, outward faces, 12 triangles.
inline TriangleMesh box(glm::vec3 low, glm::vec3 high) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y,
                                   (i & 4) ? high.z : low.z);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// Gives every triangle its own corners, as many exporters do.
inline TriangleMesh unshared(const TriangleMesh& mesh) {
    TriangleMesh result;
    for (const glm::uvec3 t : mesh.triangles) {
        const auto first = std::uint32_t(result.vertices.size());
        for (int i = 0; i < 3; ++i) result.vertices.push_back(mesh.vertices[t[i]]);
        result.triangles.emplace_back(first, first + 1, first + 2);
    }
    return result;
}

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
    append(a, b);
    return a;
}

}  // namespace noonmark::tests
