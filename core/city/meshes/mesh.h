#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace noonmark {

/// Triangles in local metres (z up). Outward faces are counter-clockwise.
struct TriangleMesh {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;  ///< indices into vertices
    bool operator==(const TriangleMesh&) const = default;
};

}  // namespace noonmark
