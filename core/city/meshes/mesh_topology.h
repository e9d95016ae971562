#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// The same mesh with points closer than `toleranceM` merged. Triangles that lose a corner by that, or have a
/// coordinate that is not a number, are dropped. O(points).
TriangleMesh weld(const TriangleMesh& mesh, float toleranceM = 0.001F);

/// For each point the index of the point that represents it: the first one found within `toleranceM`. Points
/// that are not numbers represent themselves. O(points).
std::vector<std::uint32_t> weldIndices(std::span<const glm::vec3> points, float toleranceM);

/// Removes triangles under 1e-8 m2; returns how many. Leaves the points.
std::size_t removeDegenerateTriangles(TriangleMesh& mesh);

/// Number of edges without a matching edge in the opposite direction: 0 for a closed, consistently oriented
/// mesh.
std::size_t findOpenEdges(const TriangleMesh& mesh);

/// Cubic metres; positive if the faces point outward. An open mesh is measured about the middle of its box,
/// so that the sign still shows which way most faces point.
double signedVolume(const TriangleMesh& mesh);

/// Connected components: triangles that are connected through shared points.
struct Components {
    std::vector<std::uint32_t> ofTriangle;  ///< one per triangle, 0 to count - 1
    std::uint32_t count = 0;
};
Components findComponents(const TriangleMesh& mesh);

/// One mesh per component, in the order of their numbers.
std::vector<TriangleMesh> separateComponents(const TriangleMesh& mesh, const Components& components);

void turnInsideOut(TriangleMesh& mesh);
void append(TriangleMesh& mesh, const TriangleMesh& more);

/// Turns the components whose faces point inward, except cavities: those whose box lies inside another
/// component's box. Sheets are turned to face up. Returns how many solid components were turned.
std::size_t turnOutward(TriangleMesh& mesh);

/// An axis-aligned box; liesInside() states whether it lies inside another one on all three axes, without
/// touching.
struct MeshBox {
    glm::vec3 low{1e30F};
    glm::vec3 high{-1e30F};
    [[nodiscard]] bool liesInside(const MeshBox& other) const;
};
MeshBox computeBox(const TriangleMesh& mesh);

/// Surfaces without thickness: canopies, roofs that are meshes of their own, single walls, billboards.

/// A mesh whose heights differ by less than this is level, metres. It is taken as a slab of this thickness
/// below its highest point, so that the upper face is where the sheet is; a shadow's edge moves by 1 cm x
/// cot(sun's altitude) at most.
inline constexpr float levelSheetM = 0.01F;

/// Whether a mesh is level within levelSheetM.
bool isLevel(const TriangleMesh& mesh);

/// Whether a mesh has no area from above: all faces within about one degree of vertical.
bool isUpright(const TriangleMesh& mesh);

/// Whether a mesh is a surface that covers ground without walls: it is not closed, and less than one
/// hundredth of its area is vertical. Canopies, roofs without their walls, terrain.
bool isSheet(const TriangleMesh& mesh);

/// Square metres as seen from above: upward faces minus downward faces.
double computeAreaFromAbove(const TriangleMesh& mesh);

}  // namespace noonmark
