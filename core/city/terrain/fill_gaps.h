#pragma once

#include <cstddef>
#include <vector>

namespace noonmark {

/// Gives every NaN cell of a row-major grid the value of a nearest cell that has one (in steps to the eight
/// neighbours). Returns the number of cells filled; 0 if all cells had values, or none had. O(cells).
std::size_t fillFromNearest(std::vector<float>& values, int columns, int rows);

}  // namespace noonmark
