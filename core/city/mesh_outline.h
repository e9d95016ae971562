#pragma once

#include <cstddef>
#include <vector>

#include "core/city/footprint.h"
#include "core/city/mesh.h"

namespace noonmark {

/// What a mesh covers, seen from above.
struct MeshOutline {
    std::vector<Footprint>
        pieces;  ///< disjoint, each simple and oriented; none when the mesh has no area from above
    bool convexHull =
        false;  ///< the true outline could not be had (walls alone, say), and the hull stands in
};

/// The union of the triangles' projections; gaps under 1 cm that would part it are closed, points within 1 mm
/// of straight lines and holes under 0.01 m2 left out. For a closed mesh the faces that look up are enough.
/// O(n log n). Backend: mesh_outline_geos.cpp, like all here.
MeshOutline outlineOf(const TriangleMesh& mesh, bool closed);

/// Footprints that may overlap as disjoint ones.
std::vector<Footprint> unionOf(const std::vector<Footprint>& footprints);

/// Square metres of `footprint` that none of `others` covers.
double areaOutside(const Footprint& footprint, const std::vector<Footprint>& others);

/// Which outlines stand over one another: they share more than 0.01 m2, directly or through others. A shared
/// wall line is not enough. Returns a group number for each outline, numbered from 0 by first appearance.
std::vector<std::size_t> overlapGroups(const std::vector<std::vector<Footprint>>& outlines);

}  // namespace noonmark
