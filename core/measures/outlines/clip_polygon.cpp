#include "core/measures/outlines/clip_polygon.h"

#include <cstddef>

namespace noonmark {

namespace {

// The part where `sign` x (coordinate `axis` - `at`) <= 0.
ConvexPolygon clipAt(const ConvexPolygon& polygon, int axis, double at, double sign) {
    ConvexPolygon clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double beyondA = sign * (a[axis] - at), beyondB = sign * (b[axis] - at);
        if (beyondA <= 0) clipped.push_back(a);
        if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0)) {
            glm::dvec2 crossing = a + (b - a) * (beyondA / (beyondA - beyondB));
            crossing[axis] = at;
            clipped.push_back(crossing);
        }
    }
    return clipped;
}

}  // namespace

ConvexPolygon clipToBox(const ConvexPolygon& polygon, const Box2& box) {
    ConvexPolygon clipped = polygon;
    for (int axis = 0; axis < 2 && !clipped.empty(); ++axis) {
        clipped = clipAt(clipped, axis, double(box.low[axis]), -1);
        clipped = clipAt(clipped, axis, double(box.high[axis]), 1);
    }
    return clipped.size() < 3 ? ConvexPolygon{} : clipped;
}

}  // namespace noonmark
