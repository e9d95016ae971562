#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A straight line in plan, local metres.
struct PlanLine {
    glm::dvec2 a, b;
};

/// The areas that lines enclose, as disjoint polygons. A ring inside a ring is a hole (a courtyard), a ring
/// inside that encloses an area again, and so on. Ends within 1 mm of each other are joined. O(n log n).
/// Backend of this whole file: plan_overlay_geos.cpp.
std::vector<Footprint> findEnclosedFaces(const std::vector<PlanLine>& lines);

/// All faces bounded by lines, side by side, also those inside a hole.
std::vector<Footprint> findFaces(const std::vector<PlanLine>& lines);

/// The lines, plus a line that joins the two ends of each chain that is not closed.
std::vector<PlanLine> closeChains(const std::vector<PlanLine>& lines);

/// A point strictly inside a polygon.
glm::dvec2 findPointInside(const Footprint& polygon);

/// Boxes arranged so that those at a place are found without looking at all of them. Backend:
/// plan_overlay_geos.cpp.
class BoxIndex {
public:
    explicit BoxIndex(const std::vector<Box2>& boxes);  ///< O(n log n); about 0.1 s for 43,000 boxes
    ~BoxIndex();
    BoxIndex(BoxIndex&&) noexcept;
    BoxIndex& operator=(BoxIndex&&) noexcept;

    /// Positions, in the vector given, of the boxes that intersect or touch `box`, sorted; empty boxes meet
    /// none. O(log n + found): some microseconds.
    [[nodiscard]] std::vector<std::size_t> findMeeting(const Box2& box) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

/// The smallest piece that counts as part of a building; smaller ones are drawing inaccuracies.
struct MinPiece {
    double areaM2 = 10;
    double widthM = 1;
};

/// The parts of `footprints` that none of `others` covers, without pieces that are smaller, or everywhere
/// narrower, than `minimum`. Simple and oriented. Empty also if the overlay fails. O(n log n). Backend of
/// this whole file: plan_overlay_geos.cpp.
std::vector<Footprint> cutPiecesOutside(const std::vector<Footprint>& footprints,
                                        const std::vector<Footprint>& others, MinPiece minimum);

/// Those of `others` that meet one of the footprints; all where GEOS fails. Much cheaper than cutting.
std::vector<Footprint> selectMeeting(const std::vector<Footprint>& footprints, std::vector<Footprint> others);

/// The intersection of the two, simple and oriented, without pieces under 0.01 m2. Empty also if the overlay
/// fails.
std::vector<Footprint> cutSharedPieces(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// The union, simple and oriented, without polygons and holes under 0.01 m2. Empty also if the overlay fails.
std::vector<Footprint> unitePolygons(const std::vector<Footprint>& polygons);

/// Area of the intersection of two sets of footprints that do not overlap within a set, square metres; 0 if
/// the overlay fails. Up to a million pairs of points without GEOS (plan_areas.h).
double computeSharedArea(const std::vector<Footprint>& a, const std::vector<Footprint>& b);

/// The share of an outline's length (holes included) that lies in `others` or within `besideM` of them, 0 to
/// 1; 0 if the overlay fails.
double computeShareBeside(const std::vector<Footprint>& outline, const std::vector<Footprint>& others,
                          double besideM);

/// Every pair (index in `a`, index in `b`) of boxes that intersect or touch, sorted. O((n + pairs) log n).
std::vector<std::pair<std::size_t, std::size_t>> findMeetingBoxes(const std::vector<Box2>& a,
                                                                  const std::vector<Box2>& b);

}  // namespace noonmark
