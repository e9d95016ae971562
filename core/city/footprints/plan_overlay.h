#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The smallest piece that counts as part of a building; smaller ones are drawing inaccuracies.
struct MinPiece {
    double areaM2 = 10;
    double widthM = 1;
};

/// The parts of `footprints` that none of `others` covers, without pieces that are smaller, or everywhere
/// narrower, than `least`. Simple and oriented. Empty also if the overlay fails. O(n log n). Backend of this
/// whole file: plan_overlay_geos.cpp.
std::vector<Footprint> cutPiecesOutside(const std::vector<Footprint>& footprints,
                                        const std::vector<Footprint>& others, MinPiece least);

/// Those of `others` that meet one of the footprints; all where GEOS fails. Much cheaper than cutting.
std::vector<Footprint> keepMeeting(const std::vector<Footprint>& footprints, std::vector<Footprint> others);

/// The intersection of the two, simple and oriented, without pieces under 0.01 m2. Empty also if the overlay
/// fails.
std::vector<Footprint> cutSharedPieces(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// The union, simple and oriented, without polygons and holes under 0.01 m2. Empty also if the overlay fails.
std::vector<Footprint> unitePolygons(const std::vector<Footprint>& polygons);

/// Area of the intersection of two sets of footprints that do not overlap within a set, square metres; 0 if
/// the overlay fails. Up to a million pairs of points without GEOS (shared_area.h).
double computeSharedArea(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// The share of an outline's length (holes included) that lies in `others` or within `besideM` of them, 0 to
/// 1; 0 if the overlay fails.
double computeShareBeside(const std::vector<Footprint>& outline, const std::vector<Footprint>& others,
                          double besideM);

/// Every pair (index in `a`, index in `b`) of boxes that intersect or touch, sorted. O((n + pairs) log n).
std::vector<std::pair<std::size_t, std::size_t>> findMeetingBoxes(const std::vector<Box2>& a,
                                                                  const std::vector<Box2>& b);

}  // namespace noonmark
