#include "core/city/footprints/footprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace noonmark {

namespace {

/// Where the segment meets the line on which coordinate `axis` is `limit`. In double: ends may be far away.
glm::vec2 meet(glm::vec2 from, glm::vec2 to, int axis, float limit) {
    const glm::dvec2 a(from), b(to);
    const double share = (double(limit) - a[axis]) / (b[axis] - a[axis]);
    glm::vec2 point(a + share * (b - a));
    point[axis] = limit;
    return point;
}

/// What lies at or above the limit of one axis, or at or below it.
Ring clipAt(const Ring& ring, int axis, float limit, bool above) {
    const auto inside = [&](glm::vec2 point) { return above ? point[axis] >= limit : point[axis] <= limit; };
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::vec2 before = ring[i == 0 ? ring.size() - 1 : i - 1], point = ring[i];
        if (inside(before) != inside(point)) kept.push_back(meet(before, point, axis, limit));
        if (inside(point)) kept.push_back(point);
    }
    return kept;
}

}  // namespace

Ring clipRing(const Ring& ring, const Box2& box) {
    Ring clipped = ring;
    for (const int axis : {0, 1}) {
        clipped = clipAt(clipped, axis, box.low[axis], true);
        clipped = clipAt(clipped, axis, box.high[axis], false);
    }
    return clipped.size() < 3 ? Ring{} : clipped;
}

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

double area(const std::vector<Footprint>& footprints) {
    return std::transform_reduce(footprints.begin(), footprints.end(), 0.0, std::plus(),
                                 [](const Footprint& footprint) { return area(footprint); });
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

double distanceTo(const Ring& ring, glm::dvec2 point) {
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]), along = glm::dvec2(ring[(i + 1) % ring.size()]) - a;
        const double share =
            std::clamp(glm::dot(point - a, along) / std::max(1e-12, glm::dot(along, along)), 0.0, 1.0);
        minimum = std::min(minimum, glm::distance(point, a + share * along));
    }
    return minimum;
}

bool contains(const Footprint& footprint, glm::dvec2 point) {
    bool inside = oddCrossings(footprint.outer, point);
    for (const Ring& hole : footprint.holes) inside ^= oddCrossings(hole, point);
    return inside;
}

}  // namespace noonmark
