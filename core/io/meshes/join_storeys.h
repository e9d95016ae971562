#pragma once

#include <vector>

#include "core/io/meshes/mesh_unit.h"

namespace noonmark {

/// Joins units whose lowest edges lie on the edges of a lower unit: a higher roof and the walls that rise to
/// it from the surrounding roof.
std::vector<MeshUnit> joinSteps(const std::vector<MeshUnit>& units);

/// Joins floors and ceilings that are separate meshes with the units that contain them.
void joinFloors(std::vector<MeshUnit>& units);

}  // namespace noonmark
