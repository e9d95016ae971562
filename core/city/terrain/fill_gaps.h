#pragma once

#include <cstddef>
#include <vector>

namespace noonmark {

/// Gives every NaN cell of a row-major grid the value of a nearest cell that has one (by steps to the eight
/// neighbours). Returns how many cells were filled; 0 when all had values, or none had. O(cells).
std::size_t fillFromNearest(std::vector<float>& values, int columns, int rows);

}  // namespace noonmark
