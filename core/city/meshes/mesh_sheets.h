#pragma once

#include "core/city/meshes/mesh.h"

namespace noonmark {

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
