#include "core/engines/accrual/trapezoid.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

namespace noonmark {

namespace {

constexpr double focusShare = 0.8;

// GLM matrices are column-major; the arguments are rows.
glm::dmat3 rows(glm::dvec3 first, glm::dvec3 second, glm::dvec3 third) {
    return glm::transpose(glm::dmat3(first, second, third));
}

/// Coordinates along an axis from the eye: x along it, y to its left.
struct AlongAxis {
    glm::dvec2 eye{};
    glm::dvec2 axis{1, 0};
    [[nodiscard]] glm::dvec2 of(glm::dvec2 point) const {
        const glm::dvec2 from = point - eye;
        return {glm::dot(from, axis), axis.x * from.y - axis.y * from.x};
    }
    [[nodiscard]] glm::dmat3 matrix() const {
        return rows({axis.x, axis.y, -glm::dot(axis, eye)},
                    {-axis.y, axis.x, axis.y * eye.x - axis.x * eye.y}, {0, 0, 1});
    }
};

/// Distances of points from the eye along the axis.
struct Depths {
    double nearest = 0;
    double focus = 0;  ///< distance that contains the nearest 80 % of the points
    double farthest = 0;
};

Depths depthsOf(std::vector<double> along) {
    const auto at = along.begin() + std::ptrdiff_t(double(along.size() - 1) * focusShare);
    std::nth_element(along.begin(), at, along.end());
    const auto [low, high] = std::ranges::minmax(along);
    return {low, *at, high};
}

/// A trapezoid with its axis on x, from x = nearest to x = farthest, whose sides meet at x = apex on the
/// axis.
struct Trapezoid {
    double apex = 0;
    double nearest = 0;
    double farthest = 0;
    double lowSlope = 0;  ///< of its sides: y over distance from the apex
    double highSlope = 0;

    // q is the distance from the apex, normalised to 1 in the middle of the map's length. The map's x is
    // linear between 1 / nearest and 1 / farthest, as in a perspective projection.
    [[nodiscard]] glm::dmat3 matrix(int mapSize) const {
        const double near = nearest - apex, far = farthest - apex, unit = 2 * near * far / (near + far);
        const glm::dvec3 q{1 / unit, 0, -apex / unit};
        const glm::dvec3 x = glm::dvec3{1, 0, -nearest} * (mapSize * far / (far - near) / unit) - 0.5 * q;
        const double across = mapSize / (highSlope - lowSlope) / unit;
        const glm::dvec3 y = glm::dvec3{-lowSlope, 1, lowSlope * apex} * across - 0.5 * q;
        return rows(x, y, q);
    }
};

Trapezoid trapezoidOf(const std::vector<glm::dvec2>& points, const Depths& depths, double apex) {
    Trapezoid trapezoid{apex, depths.nearest, depths.farthest, 1e30, -1e30};
    for (const glm::dvec2 point : points) {
        const double slope = point.y / (point.x - apex);
        trapezoid.lowSlope = std::min(trapezoid.lowSlope, slope);
        trapezoid.highSlope = std::max(trapezoid.highSlope, slope);
    }
    return trapezoid;
}

}  // namespace

glm::dmat3 fitBox(std::span<const glm::dvec2> points, int mapSize) {
    glm::dvec2 low = points.front(), high = low;
    for (const glm::dvec2 point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::dvec2 scale = double(mapSize) / glm::max(high - low, glm::dvec2(1e-3));
    return rows({scale.x, 0, -0.5 - low.x * scale.x}, {0, scale.y, -0.5 - low.y * scale.y}, {0, 0, 1});
}

std::optional<glm::dmat3> fitTrapezoid(std::span<const glm::dvec2> points, glm::dvec2 eye, int mapSize) {
    glm::dvec2 middle{0};
    for (const glm::dvec2 point : points) middle += point / double(points.size());
    const double away = glm::length(middle - eye);
    if (away < 1e-3) return std::nullopt;
    const AlongAxis view{eye, (middle - eye) / away};
    std::vector<glm::dvec2> seen;
    std::vector<double> along;
    for (const glm::dvec2 point : points) {
        seen.push_back(view.of(point));
        along.push_back(seen.back().x);
    }
    const Depths depths = depthsOf(std::move(along));
    // The apex lies in front of the nearest point at the distance that puts the focus at 80 % of the map.
    const double length = depths.farthest - depths.nearest, focus = depths.focus - depths.nearest;
    if (!(focus > 0) || focus >= 0.8 * focusShare * length) return std::nullopt;
    const double before = (1 - focusShare) * length * focus / (focusShare * length - focus);
    const Trapezoid trapezoid = trapezoidOf(seen, depths, depths.nearest - before);
    if (trapezoid.highSlope - trapezoid.lowSlope < 1e-9) return std::nullopt;
    return trapezoid.matrix(mapSize) * view.matrix();
}

}  // namespace noonmark
