#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// What is left of an object's name without the words for a surface of a building (WallSurface, roof, Dach,
/// window, ...) and the numbers after them: "building_12" of "building_12_WallSurface_3", "House 7" of "Roof
/// House 7" (words joined by _). Empty where the name has no such word, where nothing is left, or where only
/// a number is and the word is not one of CityGML's ("roof 3" is the third roof, not that of building 3).
/// Case does not matter; words end at what is neither letter nor digit, and where a capital follows a small
/// letter or digit.
std::string stemOfSurfaceName(std::string_view name);

/// Whether a name is made up of such words and numbers only: "RoofSurface", "walls_2".
bool isOnlySurfaceName(std::string_view name);

}  // namespace noonmark
