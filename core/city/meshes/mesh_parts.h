#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A mesh in two: all that its walls carry or enclose, and the sheets that reach beyond them.
struct CutEaves {
    TriangleMesh body;
    TriangleMesh eaves;
};

/// Cuts the roof of an open mesh along its walls, seen from above, where it overhangs them as a sheet. Eaves
/// are the faces outside of the walls that begin more than openAirM above the mesh's bottom;
/// they reach 1 cm inward, so that no slit is left. The body keeps all else but the floor outside of the
/// walls. None where the walls enclose nothing, or not all of the building: walls on the ground or a roof
/// more than 3 m away lie outside; none, too, where less than 0.1 m2 of the roof overhangs by more than 10
/// cm. O(n log n). Backend of this whole file: mesh_parts_geos.cpp.
std::optional<CutEaves> cutEaves(const TriangleMesh& mesh);

/// Height above a part's bottom (or the ground) from which on a downward face has open air below it, metres.
inline constexpr float openAirM = 2;

/// Whether a mesh has open air under some of its faces, so that it is neither a prism nor a heightfield. True
/// if downward faces that are not the walls of a cavity cover more than 0.1 m2 in plan and are more than
/// openAirM above the mesh's bottom: flat faces (within 45 degrees of level) with all their points, steep
/// faces (more than 6 degrees from vertical) with their centre. A sheet (mesh_topology.h) of the mesh counts
/// whichever way it faces, unless there are walls under walledEnough of its outline: then it is their roof.
bool hasOpenAirBelow(const TriangleMesh& mesh);

/// The share of a roof's outline that must have walls under it for them to carry the roof. In a row of houses
/// with party walls, a house may have no walls on two sides.
inline constexpr double walledEnough = 0.4;

struct MeshParts {
    std::vector<Part> parts;  ///< one per piece of the outline; none if the mesh has no area
    Warnings warnings;        ///< repairs to the mesh, with `where`
};

/// Makes parts of a mesh in local metres as read from a file: points are welded, triangles without area
/// dropped, faces turned outward, and the outline computed. A mesh that is not closed is used, with a
/// warning. `where` names the mesh in warnings. A level sheet becomes a slab, levelSheetM thick, and casts a
/// shadow like every other part; an upright sheet keeps its faces, and its footprint is a strip. A level
/// piece at the foot of others is their ground and is left out. A roof that overhangs its walls as a sheet is
/// cut along them (cutEaves()): what is outside becomes parts of its own, which are overhangs. Whether a
/// whole part is an overhang: see markOverhangs.
MeshParts partsOf(const TriangleMesh& mesh, const std::string& sourceId, const std::string& where);

/// Marks a part as an overhang if its whole underside is more than openAirM above `groundM(x, y)` and lower
/// parts that stand on the ground do not carry it: over more than 5 % of its outline's area (and more than
/// 0.5 m2, or half of the outline) nothing reaches up to its underside. Parts already marked as overhangs
/// carry nothing.
void markOverhangs(std::vector<Part>& parts, const std::function<float(glm::dvec2)>& groundM);

}  // namespace noonmark
