#pragma once

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// Surfaces without thickness: canopies, roofs that are meshes of their own, single walls, billboards.

/// A mesh whose heights differ by less is level, metres: it is taken as a slab of this thickness, downwards
/// from its highest point. Its upper face is where the sheet is; a shadow's edge moves by 1 cm x cot(sun's
/// altitude) at most.
inline constexpr float levelSheetM = 0.01F;

/// Whether a mesh is level within levelSheetM.
bool isLevel(const TriangleMesh& mesh);

/// Whether a mesh has no area from above: all of it within about one degree of plumb.
bool isUpright(const TriangleMesh& mesh);

/// Whether a mesh is a surface that covers ground without walls: it is not closed, and plumb faces make up
/// less than one hundredth of it. Canopies, roofs without their walls, terrain.
bool isSheet(const TriangleMesh& mesh);

/// Square metres as seen from above: faces that look up less those that look down.
double computeAreaFromAbove(const TriangleMesh& mesh);

}  // namespace noonmark
