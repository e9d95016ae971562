#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// Whether a repaired footprint has no hole and no corner that turns right; points on a straight wall do not
/// matter. A ring may turn left all the way and still wind twice: repaired footprints do not. O(points).
bool isConvex(const Footprint& footprint);

/// Convex pieces of a footprint that have each of its edges once: stretches of a ring that turn left all the
/// way, closed by a chord that runs inside. What stands over all pieces shades what the footprint's walls
/// shade. Points in ring order, at most `mostPoints`; two points are one edge by itself. Of a soundly
/// repaired footprint; O(points x (points that turn right + points of holes)).
std::vector<Ring> splitIntoConvexPieces(const Footprint& footprint, std::size_t mostPoints);

}  // namespace noonmark
