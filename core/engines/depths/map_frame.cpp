#include "core/engines/depths/map_frame.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

glm::dvec3 MapFrame::placed(glm::vec3 point) const {
    const glm::dvec3 from = glm::dvec3(point) - origin;
    return {glm::dot(from, u), glm::dot(from, v), glm::dot(from, normal)};
}

std::vector<glm::dvec3> MapFrame::placed(const std::vector<glm::vec3>& points) const {
    std::vector<glm::dvec3> all(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) { all[i] = placed(points[i]); });
    return all;
}

glm::dvec3 MapFrame::turned(glm::dvec3 direction) const {
    return {glm::dot(direction, u), glm::dot(direction, v), glm::dot(direction, normal)};
}

glm::dvec2 MapFrame::shearOf(glm::dvec3 towardsSun) const {
    const glm::dvec3 sun = turned(towardsSun);
    return glm::dvec2(sun.x, sun.y) / sun.z;
}

MapFrame makeGroundFrame(const Grid& grid, int mapSize, bool texelsOnCells) {
    MapFrame frame;
    frame.origin = {grid.westM, grid.southM, 0};
    const bool aligned = texelsOnCells && std::max(grid.columns, grid.rows) <= mapSize;
    frame.columns = aligned ? grid.columns : mapSize;
    frame.rows = aligned ? grid.rows : mapSize;
    frame.texelFromPlane[0][0] = frame.columns / (grid.columns * grid.cellM);
    frame.texelFromPlane[1][1] = frame.rows / (grid.rows * grid.cellM);
    frame.texelFromPlane[2] = {-0.5, -0.5, 1};
    return frame;
}

namespace {

glm::dvec3 findMiddle(const std::vector<glm::vec3>& points) {
    glm::vec3 low = points.front(), high = low;
    for (const glm::vec3 point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return (glm::dvec3(low) + glm::dvec3(high)) * 0.5;
}

MapFrame planeAcross(const SurfacePoints& points, const SunInterval& interval) {
    MapFrame frame;
    frame.origin = findMiddle(points.positions);
    frame.normal = glm::normalize(interval.first + interval.last);
    const glm::dvec3 level = glm::cross(glm::dvec3(0, 0, 1), frame.normal);
    frame.u = glm::length(level) < 1e-6 ? glm::dvec3(1, 0, 0) : glm::normalize(level);
    frame.v = glm::cross(frame.normal, frame.u);
    return frame;
}

// Points move on straight lines, so their positions at both ends bound those in between.
std::vector<glm::dvec2> thrownAtEnds(const MapFrame& frame, const SurfacePoints& points,
                                     const SunInterval& interval) {
    std::vector<glm::dvec2> thrown;
    thrown.reserve(2 * points.size());
    const std::vector<glm::dvec3> placed = frame.placed(points.positions);
    for (const glm::dvec2 shear : {frame.shearOf(interval.first), frame.shearOf(interval.last)})
        for (const glm::dvec3 p : placed) thrown.emplace_back(p.x - p.z * shear.x, p.y - p.z * shear.y);
    return thrown;
}

}  // namespace

MapFrame makeSurfaceFrame(const SurfacePoints& points, const SunInterval& interval, int mapSize, bool warp) {
    MapFrame frame = planeAcross(points, interval);
    frame.columns = frame.rows = mapSize;
    const std::vector<glm::dvec2> thrown = thrownAtEnds(frame, points, interval);
    frame.texelFromPlane = fitBox(thrown, mapSize);
    if (!warp || !points.eye) return frame;
    const glm::dvec3 eye = frame.placed(*points.eye);
    if (const auto trapezoid = fitTrapezoid(thrown, {eye.x, eye.y}, mapSize))
        frame.texelFromPlane = *trapezoid;
    return frame;
}

}  // namespace noonmark
