#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// What is too small to be a piece of a building rather than an inaccuracy of drawing.
struct LeastPiece {
    double areaM2 = 10;
    double widthM = 1;
};

/// The parts of `footprints` that none of `others` covers, without pieces that are smaller or (everywhere)
/// narrower than `least`. Simple and oriented. Empty also where the overlay fails. O(n log n). Backend:
/// plan_overlay_geos.cpp, like all here.
std::vector<Footprint> cutPiecesOutside(const std::vector<Footprint>& footprints,
                                        const std::vector<Footprint>& others, LeastPiece least);

/// What both cover, simple and oriented, without pieces under 0.01 m2. Empty also where the overlay fails.
std::vector<Footprint> cutSharedPieces(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// Square metres that both cover; 0 where the overlay fails.
double computeSharedArea(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// The share of an outline's edges (holes' too) that lies in `others` or within `besideM` of them, 0 to 1; 0
/// where the overlay fails.
double computeShareBeside(const std::vector<Footprint>& outline, const std::vector<Footprint>& others,
                          double besideM);

/// Every pair (index in `a`, index in `b`) of boxes that meet, sorted. O((n + pairs) log n).
std::vector<std::pair<std::size_t, std::size_t>> findMeetingBoxes(const std::vector<Box2>& a,
                                                                  const std::vector<Box2>& b);

}  // namespace noonmark
