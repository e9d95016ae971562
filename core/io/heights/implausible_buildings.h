#pragma once

#include <string>

#include "core/io/read_part.h"

namespace noonmark {

/// Leaves out, with a warning each, the buildings of a piece whose geometry cannot be that of one: higher
/// than 2,000 m, below or above all ground by 20 km, more than 1,000 km from the frame's origin, not finite.
/// Readers of attributes check heights themselves and have something else to stand in; a mesh's shape is all
/// there is. Error: it was so with all of them, as where the unit is not the metre. O(vertices).
Result<void> leaveOutImplausible(const std::string& file, FilePiece& piece);

}  // namespace noonmark
