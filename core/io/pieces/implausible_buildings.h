#pragma once

#include <string>

#include "core/io/pieces/read_part.h"

namespace noonmark {

/// Removes, with one warning each, the buildings of a piece whose geometry is implausible: higher than 2,000
/// m, more than 20 km below or above all ground, more than 1,000 km from the frame's origin, not finite.
/// Readers of attributes check heights themselves and have other values to use; a mesh has nothing but its
/// shape. Error: this applied to all buildings, as happens if the unit is not the metre. O(vertices).
Result<void> leaveOutImplausible(const std::string& file, FilePiece& piece);

}  // namespace noonmark
