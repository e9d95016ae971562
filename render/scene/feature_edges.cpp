#include "render/scene/feature_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace noonmark {

namespace {

// One side of a triangle, identified by the smaller and the larger of its vertex indices.
struct Side {
    std::uint64_t ends;
    std::uint32_t triangle;
};

std::uint64_t endsOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

std::vector<Side> sidesOf(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            sides.push_back({endsOf(mesh.triangles[i][corner], mesh.triangles[i][(corner + 1) % 3]), i});
    std::ranges::sort(sides, {}, &Side::ends);
    return sides;
}

glm::vec3 normalOf(const TriangleMesh& mesh, std::uint32_t triangle) {
    const glm::uvec3 corners = mesh.triangles[triangle];
    const glm::vec3 origin = mesh.vertices[corners.x];
    const glm::vec3 normal = glm::cross(mesh.vertices[corners.y] - origin, mesh.vertices[corners.z] - origin);
    const float length = glm::length(normal);
    return length > 0 ? normal / length : glm::vec3(0);
}

// Whether two faces are nearly coplanar and so show no edge between them.
bool isSmooth(const TriangleMesh& mesh, const Side* first, std::size_t faces, float cosine) {
    return faces == 2 &&
           glm::dot(normalOf(mesh, first[0].triangle), normalOf(mesh, first[1].triangle)) > cosine;
}

}  // namespace

std::vector<std::uint32_t> findFeatureEdges(const TriangleMesh& mesh, double angleDeg) {
    const std::vector<Side> sides = sidesOf(mesh);
    const auto cosine = float(std::cos(glm::radians(angleDeg)));
    std::vector<std::uint32_t> edges;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
        if (!isSmooth(mesh, &sides[i], end - i, cosine)) {
            edges.push_back(std::uint32_t(sides[i].ends >> 32));
            edges.push_back(std::uint32_t(sides[i].ends));
        }
        i = end;
    }
    return edges;
}

}  // namespace noonmark
