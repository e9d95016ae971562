#pragma once

#include <cstddef>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// The outline of a mesh, seen from above.
struct MeshOutline {
    std::vector<Footprint> pieces;  ///< disjoint, each simple and oriented; none when the mesh has no area
    /// No face of the mesh covers ground; the pieces are the area that its walls enclose
    bool wallsOnly = false;
};

/// The union of the triangles' projections. Gaps under 1 cm that would split it are closed; points within 1
/// mm of straight lines and holes under 0.01 m2 are dropped. For a closed mesh the upward faces are enough.
/// Walls that project from the outline are added as strips, wallStripM wide. A mesh of walls only gives the
/// area that they enclose, or else such strips. `sections`: cuts through a solid, which its outline covers;
/// they save the work for the triangles over them. O(n log n). Backend of this whole file:
/// mesh_outline_geos.cpp.
MeshOutline computeOutline(const TriangleMesh& mesh, bool closed,
                           const std::vector<Footprint>& sections = {});
inline constexpr double wallStripM = 0.01;

/// The area that the vertical faces of a mesh enclose, seen from above: the ground inside a ring of walls. A
/// ring within it is a hole, as of a courtyard, and so on. Empty if the walls leave a gap over 1 mm. Only
/// walls that begin no more than `aboveM` above the mesh's bottom count.
std::vector<Footprint> findEnclosedByWalls(const TriangleMesh& mesh, float aboveM);

/// The share of an outline's length with vertical faces of the mesh under it, 0 to 1. Only faces that lie
/// within 1 m of the outline, or inside it, and begin no more than `aboveM` above the mesh's bottom count.
double computeWalledShare(const TriangleMesh& mesh, const Footprint& outline, float aboveM);

/// The union of footprints that may overlap, as disjoint footprints.
std::vector<Footprint> computeUnion(const std::vector<Footprint>& footprints);

/// Square metres of `footprint` that none of `others` covers.
double computeAreaOutside(const Footprint& footprint, const std::vector<Footprint>& others);

/// Groups outlines that overlap by more than 0.01 m2, directly or through others; a shared wall line is not
/// enough. Returns a group number for each outline, numbered from 0 by first appearance.
std::vector<std::size_t> groupOverlapping(const std::vector<std::vector<Footprint>>& outlines);

}  // namespace noonmark
