#pragma once

#include <cstddef>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// What a mesh covers, seen from above.
struct MeshOutline {
    std::vector<Footprint> pieces;  ///< disjoint, each simple and oriented; none when the mesh has no area
    bool wallsOnly = false;  ///< nothing of the mesh covers ground; the pieces are what its walls enclose
};

/// The union of the triangles' projections; gaps under 1 cm that would part it are closed, points within 1 mm
/// of straight lines and holes under 0.01 m2 left out. For a closed mesh the faces that look up are enough.
/// Walls that stand out of it belong to it as strips, wallStripM wide. Of walls alone: what they enclose,
/// else such strips. O(n log n). Backend: mesh_outline_geos.cpp, like all here.
MeshOutline computeOutline(const TriangleMesh& mesh, bool closed);
inline constexpr double wallStripM = 0.01;

/// What the plumb faces of a mesh enclose, seen from above: the ground inside a ring of walls; a ring within
/// it, as of a courtyard, encloses what is outside, and so on. None where the walls leave a gap over 1 mm.
/// Of walls that begin no more than `aboveM` above the mesh's bottom.
std::vector<Footprint> findEnclosedByWalls(const TriangleMesh& mesh, float aboveM);

/// The share of an outline's length that plumb faces of a mesh stand under, 0 to 1: those that lie within 1 m
/// of it or inside, and begin no more than `aboveM` above the mesh's bottom.
double computeWalledShare(const TriangleMesh& mesh, const Footprint& outline, float aboveM);

/// Footprints that may overlap as disjoint ones.
std::vector<Footprint> computeUnion(const std::vector<Footprint>& footprints);

/// Square metres of `footprint` that none of `others` covers.
double computeAreaOutside(const Footprint& footprint, const std::vector<Footprint>& others);

/// Which outlines stand over one another: they share more than 0.01 m2, directly or through others. A shared
/// wall line is not enough. Returns a group number for each outline, numbered from 0 by first appearance.
std::vector<std::size_t> groupOverlapping(const std::vector<std::vector<Footprint>>& outlines);

}  // namespace noonmark
