#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/meshes/mesh_units.h"

namespace noonmark {

/// An object's name without the words for surfaces of a building (WallSurface, roof, Dach, window, ...) and
/// the numbers after them: "building_12" for "building_12_WallSurface_3", "House 7" for "Roof House 7" (words
/// joined by _). Empty if the name has no such word, if nothing is left, or if only a number is left and the
/// word is not one of CityGML's ("roof 3" is the third roof, not the roof of building 3). Case does not
/// matter. A word ends at a character that is neither letter nor digit, and before a capital that follows a
/// small letter or digit.
std::string stemOfSurfaceName(std::string_view name);

/// Whether a name consists of such words and numbers only: "RoofSurface", "walls_2".
bool isOnlySurfaceName(std::string_view name);

/// Takes the roofs (sheets without walls) among `units` apart: faces that share an edge belong to one roof,
/// unless a wall ends at that edge. The other units come first and stay as they are.
std::vector<MeshUnit> separateRoofs(std::vector<MeshUnit> units, const std::vector<MeshUnit>& walls);

}  // namespace noonmark
