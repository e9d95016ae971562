#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace noonmark {

/// A closed ring of points in local metres; the last point joins the first and is not repeated.
using Ring = std::vector<glm::vec2>;

/// A simple polygon: outer ring counter-clockwise, holes clockwise, none touching itself along a line. At
/// least three points a ring. Made by repair_footprint.h; what comes from elsewhere must be repaired first.
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

/// Metres squared; positive when counter-clockwise. In double, relative to the first point, so that it does
/// not cancel far from the origin.
double signedArea(const Ring& ring);

/// Outer ring minus holes, metres squared.
double area(const Footprint& footprint);

Box2 bounds(const Ring& ring);
Box2 bounds(const Footprint& footprint);

/// Half-open: of two footprints that share an edge, a point on it is in just one. The rule: a point on a
/// western or southern edge is inside, on an eastern or northern edge outside. O(points).
bool contains(const Footprint& footprint, glm::dvec2 point);

}  // namespace noonmark
