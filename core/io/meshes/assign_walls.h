#pragma once

#include <vector>

#include "core/io/meshes/mesh_unit.h"

namespace noonmark {

/// Which units take walls that lie under them.
enum class Under { openRoofs, anyRoof };

/// Adds each face of a wall to the unit over it, or within 0.25 m of it in plan; of several to the one whose
/// points are nearest to the face's top. Returns the walls that are under none.
std::vector<MeshUnit> assignWalls(std::vector<MeshUnit>& units, Under under,
                                  const std::vector<MeshUnit>& walls);

/// Adds walls without a roof: they join the only unit of their object; otherwise each connected set of them
/// is a unit.
void addWalls(const std::vector<MeshUnit>& walls, std::vector<MeshUnit>& units);

}  // namespace noonmark
