#pragma once

// The folder core/city/footprints handles polygons in plan. Footprint (this file) is the valid polygon that
// the whole program uses; repair_footprint.h makes it from rings as they are read, and tangled_rings.h
// refuses rings that would take too long. triangulate.h triangulates it, plan_overlay.h intersects and
// subtracts footprints, plan_lines.h finds the faces between lines, floor_area.h sums storeys. Files that end
// in _geos.cpp or _cgal.cpp use that library; geos_shapes.h wraps GEOS for them.

#include <glm/vec2.hpp>
#include <vector>

namespace noonmark {

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

Box2 bounds(const Ring& ring);
Box2 bounds(const Footprint& footprint);

/// Half-open: if two footprints share an edge, a point on it is in exactly one of them. A point on a western
/// or southern edge is inside, on an eastern or northern edge outside. O(points).
bool contains(const Footprint& footprint, glm::dvec2 point);

}  // namespace noonmark
