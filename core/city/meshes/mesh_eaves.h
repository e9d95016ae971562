#pragma once

#include <optional>

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A mesh in two: all that its walls carry or enclose, and the sheets that reach beyond them.
struct CutEaves {
    TriangleMesh body;
    TriangleMesh eaves;
};

/// Cuts the roof of an open mesh along its walls, seen from above, where it overhangs them as a sheet. Eaves
/// are the faces outside of the walls that begin more than openAirM (mesh_parts.h) above the mesh's bottom;
/// they reach 1 cm inward, so that no slit is left. The body keeps all else but the floor outside of the
/// walls. None where the walls enclose nothing, or not all of the building: walls on the ground or a roof
/// more than 3 m away lie outside; none, too, where less than 0.1 m2 of the roof overhangs by more than 10
/// cm. O(n log n). Backend of this whole file: mesh_eaves_geos.cpp.
std::optional<CutEaves> cutEaves(const TriangleMesh& mesh);

}  // namespace noonmark
