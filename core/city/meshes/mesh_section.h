#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A horizontal section through a mesh.
struct MeshSection {
    std::vector<Footprint>
        pieces;  ///< disjoint; courtyards and cavities are left out, solids that overlap count once
    bool estimated = false;  ///< the mesh is open there: see sectionAt
};

/// The section at local z `heightM`; a point at that height counts as above it. A mesh that is closed: what
/// is inside, by winding number. One that is open: what its cut walls enclose, chains of them with two ends
/// closed by a straight line (a missing party wall); where they enclose nothing, what of the mesh above that
/// height covers, seen from above. O(triangles + n log n of those cut).
MeshSection cutSection(const TriangleMesh& mesh, double heightM);

}  // namespace noonmark
