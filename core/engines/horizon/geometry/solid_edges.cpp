#include "core/engines/horizon/geometry/solid_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

namespace noonmark {

namespace {

/// One side of a triangle, to be matched with the same side of the adjacent triangle.
struct Side {
    std::uint32_t low, high;  // indices of the ends
    std::uint32_t face;
    bool forward;  // the triangle runs from low to high
};

std::vector<Side> sortedSides(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = mesh.triangles[face][i], b = mesh.triangles[face][(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), face, a < b});
        }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return sides;
}

// Whether the faces are halves of one plane face, up to rounding.
bool isFlat(glm::vec3 one, glm::vec3 other) {
    constexpr float least = 1e-6F;  // radians
    return glm::dot(one, other) > 0 && glm::length(glm::cross(one, other)) < least;
}

// A side where more than two faces meet is treated as a boundary of each.
void addEdges(const Side* first, const Side* end, StandingSolid& solid) {
    if (end - first == 2 && first[0].forward != first[1].forward) {
        if (isFlat(solid.normals[first[0].face], solid.normals[first[1].face])) return;
        const bool forward = first[0].forward;
        solid.edges.push_back(
            {first->low, first->high, first[forward ? 0 : 1].face, first[forward ? 1 : 0].face});
        return;
    }
    for (const Side* side = first; side != end; ++side)
        solid.edges.push_back({side->forward ? side->low : side->high, side->forward ? side->high : side->low,
                               side->face, SolidEdge::noFace});
}

}  // namespace

StandingSolid makeStandingSolid(const TriangleMesh& mesh, std::uint32_t building, const Grid& grid,
                                double datumM) {
    StandingSolid solid{.building = building,
                        .topM = std::numeric_limits<float>::lowest(),
                        .low = glm::dvec2(1e30),
                        .high = glm::dvec2(-1e30)};
    for (const glm::vec3 vertex : mesh.vertices) {
        const glm::dvec2 cells{(double(vertex.x) - grid.westM) / grid.cellM - 0.5,
                               (double(vertex.y) - grid.southM) / grid.cellM - 0.5};
        solid.vertices.emplace_back(cells, double(vertex.z) - datumM);
        solid.low = glm::min(solid.low, cells);
        solid.high = glm::max(solid.high, cells);
        solid.topM = std::max(solid.topM, float(double(vertex.z) - datumM));
    }
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        solid.normals.emplace_back(normal / std::max(1e-12, glm::length(normal)));
    }
    const std::vector<Side> sides = sortedSides(mesh);
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
        while (end < sides.size() && sides[end].low == sides[first].low &&
               sides[end].high == sides[first].high)
            ++end;
        addEdges(sides.data() + first, sides.data() + end, solid);
    }
    return solid;
}

}  // namespace noonmark
