#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// The same mesh with points closer than `toleranceM` made one. Triangles that lose a corner by that, or have
/// a coordinate that is no number, are left out. O(points).
TriangleMesh weld(const TriangleMesh& mesh, float toleranceM = 0.001F);

/// For each point the index of the one that stands for it: the first that was found within `toleranceM`.
/// Points that are no number stand for themselves. O(points).
std::vector<std::uint32_t> weldIndices(std::span<const glm::vec3> points, float toleranceM);

/// Takes out triangles under 1e-8 m2; says how many. The points stay.
std::size_t removeDegenerateTriangles(TriangleMesh& mesh);

/// Edges that are not matched by as many running the other way: 0 for a closed, evenly oriented mesh.
std::size_t findOpenEdges(const TriangleMesh& mesh);

/// Cubic metres; positive when the faces look outward. For a mesh with a gap: measured about the middle of
/// its box, so that the sign still tells which way most faces look.
double signedVolume(const TriangleMesh& mesh);

/// Which triangles hang together through shared points.
struct Components {
    std::vector<std::uint32_t> ofTriangle;  ///< one per triangle, 0 to count - 1
    std::uint32_t count = 0;
};
Components findComponents(const TriangleMesh& mesh);

/// One mesh a component, in the order of their numbers.
std::vector<TriangleMesh> separateComponents(const TriangleMesh& mesh, const Components& components);

void turnInsideOut(TriangleMesh& mesh);
void append(TriangleMesh& mesh, const TriangleMesh& more);

/// Turns the components whose faces look inward, except cavities: those whose box lies inside another
/// component's box. Sheets are turned to look up. Returns how many solid components were turned.
std::size_t turnOutward(TriangleMesh& mesh);

/// Whether `box` of one mesh lies inside that of the other, all three axes, without touching.
struct Box3 {
    glm::vec3 low{1e30F};
    glm::vec3 high{-1e30F};
    [[nodiscard]] bool liesInside(const Box3& other) const;
};
Box3 computeBox(const TriangleMesh& mesh);

}  // namespace noonmark
