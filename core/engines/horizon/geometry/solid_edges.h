#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "core/geo/grid.h"

namespace noonmark {

/// The tangent of the sun's altitude up to which a face with outward unit normal `n` is turned away from a
/// sun that throws shadows along `away`: infinite for plumb faces behind the solid and for those that look
/// down, minus infinite for plumb faces before it.
inline float backLitBelow(glm::vec3 n, glm::vec2 away) {
    constexpr float plumb = 1e-6F;
    const float forward = n.x * away.x + n.y * away.y;
    if (n.z > plumb) return forward / n.z;
    const float infinite = std::numeric_limits<float>::infinity();
    return n.z < -plumb || forward > 0 ? infinite : -infinite;
}

/// Whether an edge between two faces bounds what hides a sun of this tangent or a higher one.
inline bool isOutline(float oneBackLitBelow, float otherBackLitBelow, float lowestTan) {
    return oneBackLitBelow != otherBackLitBelow &&
           (oneBackLitBelow > lowestTan || otherBackLitBelow > lowestTan);
}

/// An edge of a solid, by index of its ends and of the two faces that meet in it.
struct SolidEdge {
    static constexpr std::uint32_t noFace = 0xFFFFFFFF;  ///< at the rim of a surface that is not closed
    std::uint32_t a, b;
    std::uint32_t left, right;  ///< `left` is to the left of a -> b, seen from outside
};

/// A solid that stands on the ground, given by its surface: whatever is below its faces is solid. The slope
/// of its horizon is that of its edges between a face that the sun reaches and one that it does not.
struct StandingSolid {
    std::uint32_t building = 0;
    float topM = 0;
    glm::dvec2 low{}, high{};          ///< bounds, cells
    std::vector<glm::dvec3> vertices;  ///< x, y in cells, z in metres above the datum
    std::vector<glm::vec3> normals;    ///< outward, of each face; 0 for one without area
    std::vector<SolidEdge> edges;      ///< those where the surface bends
};

/// The solid below a mesh. `datumM`: local z that heights count from. O(triangles log triangles).
StandingSolid makeStandingSolid(const TriangleMesh& mesh, std::uint32_t building, const Grid& grid,
                                double datumM);

}  // namespace noonmark
