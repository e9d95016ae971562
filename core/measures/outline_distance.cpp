#include "core/measures/outline_distance.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace noonmark {

namespace {

double distanceToSide(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(point - (a + along * share));
}

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

double betweenBoxes(const Box2& a, const Box2& b) {
    const glm::dvec2 gap = glm::max(glm::dvec2(0), glm::max(glm::dvec2(a.low) - glm::dvec2(b.high),
                                                            glm::dvec2(b.low) - glm::dvec2(a.high)));
    return glm::length(gap);
}

double betweenRings(const Ring& a, const Ring& b, double atMost) {
    for (std::size_t i = 0, k = a.size() - 1; i < a.size(); k = i++)
        for (std::size_t j = 0, l = b.size() - 1; j < b.size(); l = j++) {
            const glm::dvec2 p(a[k]), q(a[i]), r(b[l]), s(b[j]);
            if (cross(p, q, r, s)) return 0;
            atMost = std::min({atMost, distanceToSide(p, r, s), distanceToSide(r, p, q)});
        }
    return atMost;
}

std::vector<const Ring*> ringsOf(const Footprint& polygon) {
    std::vector<const Ring*> rings{&polygon.outer};
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
    return rings;
}

double between(const Footprint& a, const Footprint& b, double atMost) {
    if (a.outer.empty() || b.outer.empty() || betweenBoxes(bounds(a), bounds(b)) >= atMost) return atMost;
    if (contains(a, glm::dvec2(b.outer.front())) || contains(b, glm::dvec2(a.outer.front()))) return 0;
    for (const Ring* one : ringsOf(a))
        for (const Ring* other : ringsOf(b)) atMost = betweenRings(*one, *other, atMost);
    return atMost;
}

}  // namespace

double measureDistanceM(const std::vector<Footprint>& a, const std::vector<Footprint>& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Footprint& one : a)
        for (const Footprint& other : b) least = between(one, other, least);
    return least;
}

}  // namespace noonmark
