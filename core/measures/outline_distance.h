#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The shortest distance between two groups of polygons in plan, metres; 0 where they overlap or touch.
/// Infinite where one group is empty. O(sides x sides) for those whose boxes are not farther apart than what
/// was found before.
double measureDistanceM(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

}  // namespace noonmark
