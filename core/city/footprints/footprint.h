#pragma once

// The folder core/city/footprints handles polygons in plan. Footprint (this file) is the valid polygon that
// the whole program uses; repair_footprint.h makes it from rings as they are read, and refuses rings that
// would take too long. triangulate.h triangulates it; plan_overlay.h intersects and subtracts footprints, and
// finds the faces between lines; plan_areas.h sums storeys. Files that end in _geos.cpp or _cgal.cpp use that
// library; geos_shapes.h wraps GEOS for them.

#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace noonmark {

/// The intersection of an edge with a horizontal line. `contains` and the rasteriser share this rule, so that
/// they agree to the last bit. The result does not depend on the direction of the edge, so that neighbours
/// agree on a shared edge too.

/// Half-open: a line through the edge's lower end crosses it, a line through the upper end does not; a
/// horizontal edge never crosses.
inline bool crossesRow(glm::vec2 a, glm::vec2 b, double y) {
    return (double(a.y) <= y) != (double(b.y) <= y);
}

/// x of the crossing, metres; valid only if crossesRow().
inline double crossingX(glm::vec2 a, glm::vec2 b, double y) {
    if (a.y > b.y) std::swap(a, b);
    return double(a.x) + (y - double(a.y)) * (double(b.x) - double(a.x)) / (double(b.y) - double(a.y));
}

/// A closed ring of points in local metres; the last point connects to the first, which is not repeated.
using Ring = std::vector<glm::vec2>;

/// A simple polygon: outer ring counter-clockwise, holes clockwise, no ring touching itself along a line. At
/// least three points in each ring. repair_footprint.h makes such polygons; polygons from other sources must
/// be repaired first.
struct Footprint {
    Ring outer;
    std::vector<Ring> holes;
    bool operator==(const Footprint&) const = default;
};

/// An axis-aligned box in local metres; empty when low > high.
struct Box2 {
    glm::vec2 low{1e30F, 1e30F};
    glm::vec2 high{-1e30F, -1e30F};
    void add(glm::vec2 point);
    void add(const Box2& other);
    [[nodiscard]] bool empty() const { return low.x > high.x || low.y > high.y; }
    bool operator==(const Box2&) const = default;
};

/// Square metres; positive if counter-clockwise. Computed in double relative to the first point, so that
/// digits do not cancel far from the origin.
double signedArea(const Ring& ring);

/// Outer ring minus holes, square metres.
double area(const Footprint& footprint);
double area(const std::vector<Footprint>& footprints);  ///< their sum, common parts twice

Box2 bounds(const Ring& ring);
Box2 bounds(const Footprint& footprint);

/// Metres to the nearest point of the outline, from either side of it. O(points).
double distanceTo(const Ring& ring, glm::dvec2 point);

/// Half-open: if two footprints share an edge, a point on it is in exactly one of them. A point on a western
/// or southern edge is inside, on an eastern or northern edge outside. O(points).
bool contains(const Footprint& footprint, glm::dvec2 point);

/// The part of a ring inside the box (Sutherland and Hodgman); empty where there is none. Pieces that the box
/// separates stay joined along its edges, so that inside and outside by the even-odd rule stay the same
/// within the box, and a ring that crosses itself is no error. O(points).
Ring clipRing(const Ring& ring, const Box2& box);

}  // namespace noonmark
