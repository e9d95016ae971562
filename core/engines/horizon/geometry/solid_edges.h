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
/// sun that casts shadows in direction `away`. Infinite for vertical faces at the back of the solid and for
/// faces that look down; minus infinite for vertical faces at the front.
inline float backLitBelow(glm::vec3 n, glm::vec2 away) {
    constexpr float plumb = 1e-6F;
    const float forward = n.x * away.x + n.y * away.y;
    if (n.z > plumb) return forward / n.z;
    const float infinite = std::numeric_limits<float>::infinity();
    return n.z < -plumb || forward > 0 ? infinite : -infinite;
}

/// Whether an edge between two faces is part of the outline seen from a sun of this tangent or a higher one.
inline bool isOutline(float oneBackLitBelow, float otherBackLitBelow, float lowestTan) {
    return oneBackLitBelow != otherBackLitBelow &&
           (oneBackLitBelow > lowestTan || otherBackLitBelow > lowestTan);
}

/// An edge of a solid, with the indices of its ends and of the two adjacent faces.
struct SolidEdge {
    static constexpr std::uint32_t noFace = 0xFFFFFFFF;  ///< at the boundary of a surface that is not closed
    std::uint32_t a, b;
    std::uint32_t left, right;  ///< `left` is to the left of a -> b as seen from outside
};

/// A solid that stands on the ground, given by its surface; everything below its faces is solid. The slope of
/// its horizon is determined by the edges between a face that the sun reaches and one that it does not.
struct StandingSolid {
    std::uint32_t building = 0;
    float topM = 0;
    glm::dvec2 low{}, high{};          ///< bounds in cells
    std::vector<glm::dvec3> vertices;  ///< x, y in cells, z in metres above the datum
    std::vector<glm::vec3> normals;    ///< outward, one per face; 0 for a face without area
    std::vector<SolidEdge> edges;      ///< only edges at which the surface bends
};

/// The solid below a mesh. `datumM`: local z from which heights are measured. O(triangles log triangles).
StandingSolid makeStandingSolid(const TriangleMesh& mesh, std::uint32_t building, const Grid& grid,
                                double datumM);

}  // namespace noonmark
