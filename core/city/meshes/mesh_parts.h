#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building.h"

namespace noonmark {

/// How far above a part's bottom (or the ground) a face must begin to have open air below it, metres.
inline constexpr float openAirM = 2;

/// Whether a mesh has open air under some of its faces, so that it is no prism and no heightfield. The rule:
/// faces that look down and are not the walls of a cavity cover more than 0.1 m2 from above, and are clear of
/// the mesh's bottom by more than openAirM: flat ones (within 45 degrees of level) with all their points,
/// leaning ones (more than 6 degrees off plumb) with their middle. A sheet (mesh_sheets.h) of the mesh counts
/// whichever way it looks, unless walls stand under walledEnough of its outline: then it is their roof.
bool hasOpenAirBelow(const TriangleMesh& mesh);

/// The share of a roof's outline from which on walls under it carry it. Where neighbours share their party
/// walls, a house may have none on two sides.
inline constexpr double walledEnough = 0.4;

struct MeshParts {
    std::vector<Part> parts;  ///< one per piece of the outline; none if the mesh has no area
    Warnings warnings;        ///< what was mended, with `where`
};

/// Makes parts of a mesh in local metres as it came from a file: points welded, triangles without area
/// dropped, faces turned outward, outline taken. A mesh that is not closed is used, with a warning. `where`
/// names it in warnings. A level sheet becomes a slab, levelSheetM thick, and casts its shadow as every other
/// part does; an upright one keeps its faces, and its footprint is a strip. A level piece at the foot of
/// others is their ground and is left out. Whether the whole part is an overhang: markHanging.
MeshParts partsOf(const TriangleMesh& mesh, const std::string& sourceId, const std::string& where);

/// Marks parts whose whole underside is more than openAirM above `groundM(x, y)` and is not carried by lower
/// parts that stand: more than 5 % of its outline (and 0.5 m2, or half of it) has nothing under it that
/// reaches up to its bottom. Parts that hang already carry nothing.
void markOverhangs(std::vector<Part>& parts, const std::function<float(glm::dvec2)>& groundM);

}  // namespace noonmark
