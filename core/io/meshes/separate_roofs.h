#pragma once

#include <vector>

#include "core/io/meshes/mesh_unit.h"

namespace noonmark {

/// Takes the roofs (sheets without walls) among `units` apart: faces that share an edge belong to one roof,
/// unless a wall ends at that edge. The other units come first and stay as they are.
std::vector<MeshUnit> separateRoofs(std::vector<MeshUnit> units, const std::vector<MeshUnit>& walls);

}  // namespace noonmark
