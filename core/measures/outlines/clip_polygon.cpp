#include "core/measures/outlines/clip_polygon.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <glm/common.hpp>

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

double twiceAreaOf(const ConvexPolygon& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const glm::dvec2 u = polygon[i] - polygon[0], v = polygon[i + 1] - polygon[0];
        sum += u.x * v.y - u.y * v.x;
    }
    return sum;
}

/// A polygon that may contain others.
class Container {
public:
    explicit Container(const ConvexPolygon& polygon)
        : polygon_(&polygon), low_(polygon[0]), high_(polygon[0]) {
        for (const glm::dvec2 point : polygon) {
            low_ = glm::min(low_, point);
            high_ = glm::max(high_, point);
        }
    }
    [[nodiscard]] bool contains(const Container& other) const {
        return low_.x <= other.low_.x && low_.y <= other.low_.y && high_.x >= other.high_.x &&
               high_.y >= other.high_.y &&
               std::ranges::all_of(*other.polygon_, [&](glm::dvec2 point) { return isInside(point); });
    }

    [[nodiscard]] const ConvexPolygon& polygon() const { return *polygon_; }

private:
    [[nodiscard]] bool isInside(glm::dvec2 point) const {
        for (std::size_t i = 0, j = polygon_->size() - 1; i < polygon_->size(); j = i++) {
            const glm::dvec2 along = (*polygon_)[i] - (*polygon_)[j], to = point - (*polygon_)[j];
            if (along.x * to.y - along.y * to.x < 0) return false;
        }
        return true;
    }

    const ConvexPolygon* polygon_;
    glm::dvec2 low_, high_;
};

}  // namespace

void dropContained(std::vector<ConvexPolygon>& polygons) {
    std::ranges::sort(polygons, std::greater{}, twiceAreaOf);
    std::vector<Container> left;
    std::vector<ConvexPolygon> all;
    all.swap(polygons);
    for (ConvexPolygon& polygon : all) {
        const Container candidate(polygon);
        if (std::ranges::none_of(left, [&](const Container& other) { return other.contains(candidate); }))
            left.push_back(candidate);
    }
    for (const Container& container : left) polygons.push_back(container.polygon());
}

ConvexPolygon clipToBox(const ConvexPolygon& polygon, const Box2& box) {
    ConvexPolygon clipped = polygon;
    for (int axis = 0; axis < 2 && !clipped.empty(); ++axis) {
        clipped = clipAt(clipped, axis, double(box.low[axis]), -1);
        clipped = clipAt(clipped, axis, double(box.high[axis]), 1);
    }
    return clipped.size() < 3 ? ConvexPolygon{} : clipped;
}

}  // namespace noonmark
