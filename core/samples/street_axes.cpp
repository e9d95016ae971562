#include "core/samples/street_axes.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace noonmark {

namespace {
// Sine and cosine of 29 degrees.
constexpr double sine = 0.48480962024633706;
constexpr double cosine = 0.87461970713939574;

// The part with east - eastPerNorth * north >= limit (side 1) or <= limit (side -1), by Sutherland and
// Hodgman's clipping.
StreetPolygon halfOf(const StreetPolygon& polygon, double eastPerNorth, double limit, int side) {
    const auto beyond = [&](glm::dvec2 p) { return side * (p.x - eastPerNorth * p.y - limit); };
    StreetPolygon half;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        const double from = beyond(a);
        const double to = beyond(b);
        if (from >= 0) half.push_back(a);
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) half.push_back(a + (b - a) * (from / (from - to)));
    }
    return half;
}
}  // namespace

glm::dvec2 StreetAxes::localFromStreet(glm::dvec2 street) const {
    return origin + glm::dvec2{cosine * street.x + sine * street.y, cosine * street.y - sine * street.x};
}

glm::dvec2 StreetAxes::streetFromLocal(glm::dvec2 local) const {
    const glm::dvec2 d = local - origin;
    return {cosine * d.x - sine * d.y, sine * d.x + cosine * d.y};
}

StreetPolygon cornersOf(const StreetBox& box) {
    return {{box.west, box.south}, {box.east, box.south}, {box.east, box.north}, {box.west, box.north}};
}

double computeArea(const StreetPolygon& polygon) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i] - polygon[0];
        const glm::dvec2 b = polygon[i + 1] - polygon[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

StreetPolygon SkewedAvenue::clipped(const StreetPolygon& polygon) const {
    const double half = widthM / 2 * std::sqrt(1 + eastPerNorth * eastPerNorth);
    const double middle = through.x - eastPerNorth * through.y;
    StreetPolygon west = halfOf(polygon, eastPerNorth, middle - half, -1);
    StreetPolygon east = halfOf(polygon, eastPerNorth, middle + half, 1);
    return computeArea(west) > computeArea(east) ? std::move(west) : std::move(east);
}

}  // namespace noonmark
