#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/city/city.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A horizontal section through a mesh.
struct MeshSection {
    std::vector<Footprint>
        pieces;  ///< disjoint; courtyards and cavities are left out, solids that overlap count once
    bool estimated = false;  ///< the mesh is open at that height: see cutSection
};

/// The section at local z `heightM`; a point at that height counts as above it. For a closed mesh: the
/// inside, by winding number. For an open mesh: the area that the cut walls enclose, after each open chain of
/// walls was closed by a straight line between its ends (a missing party wall); if they enclose nothing, the
/// outline, seen from above, of the mesh above that height. O(triangles + n log n of those cut).
MeshSection cutSection(const TriangleMesh& mesh, double heightM);

/// Outlines of a building at the floors of its storeys, one closed ring each, as seen from outside: every
/// `storeyHeightM` (over 0) above `groundM` (local z) up to its top, without the ground floor's. At most 1000
/// floors. A mesh costs some ms for a hundred storeys.
std::vector<std::vector<glm::vec3>> makeStoreyLines(const Building& building, double groundM,
                                                    double storeyHeightM);

}  // namespace noonmark
