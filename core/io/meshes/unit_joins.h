#pragma once

#include <vector>

#include "core/io/meshes/mesh_units.h"

namespace noonmark {

/// Joins units whose lowest edges lie on the edges of a lower unit: a higher roof and the walls that rise to
/// it from the surrounding roof.
std::vector<MeshUnit> joinSteps(const std::vector<MeshUnit>& units);

/// Joins floors and ceilings that are separate meshes with the units that contain them.
void joinFloors(std::vector<MeshUnit>& units);

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
