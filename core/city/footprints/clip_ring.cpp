#include "core/city/footprints/clip_ring.h"

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

}  // namespace noonmark
