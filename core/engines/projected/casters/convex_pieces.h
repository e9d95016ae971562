#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// Whether a repaired footprint has no hole and no corner that turns right; points on a straight wall are
/// ignored. A ring may turn left all the way and still wind twice, but repaired footprints never do.
/// O(points).
bool isConvex(const Footprint& footprint);

/// Splits a footprint into convex pieces that contain each of its edges once: sections of a ring that turn
/// left all the way, closed by a chord inside the footprint. Prisms over all pieces cast the same shadow as
/// the footprint's walls. Points in ring order, at most `maxPoints` per piece; a piece of two points is a
/// single edge. The footprint must be properly repaired. O(points x (points that turn right + points of
/// holes)).
std::vector<Ring> splitIntoConvexPieces(const Footprint& footprint, std::size_t maxPoints);

}  // namespace noonmark
