#include "core/city/footprints/footprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

#include "core/city/footprints/crossing.h"

namespace noonmark {

void Box2::add(glm::vec2 point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void Box2::add(const Box2& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

double signedArea(const Ring& ring) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const glm::dvec2 a = glm::dvec2(ring[i]) - glm::dvec2(ring[0]);
        const glm::dvec2 b = glm::dvec2(ring[i + 1]) - glm::dvec2(ring[0]);
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

double area(const Footprint& footprint) {
    double sum = std::abs(signedArea(footprint.outer));
    for (const Ring& hole : footprint.holes) sum -= std::abs(signedArea(hole));
    return sum;
}

Box2 bounds(const Ring& ring) {
    Box2 box;
    for (const glm::vec2 point : ring) box.add(point);
    return box;
}

Box2 bounds(const Footprint& footprint) { return bounds(footprint.outer); }

namespace {
bool oddCrossings(const Ring& ring, glm::dvec2 point) {
    bool odd = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        if (!crossesRow(ring[j], ring[i], point.y)) continue;
        if (crossingX(ring[j], ring[i], point.y) <= point.x) odd = !odd;
    }
    return odd;
}
}  // namespace

bool contains(const Footprint& footprint, glm::dvec2 point) {
    bool inside = oddCrossings(footprint.outer, point);
    for (const Ring& hole : footprint.holes) inside ^= oddCrossings(hole, point);
    return inside;
}

}  // namespace noonmark
