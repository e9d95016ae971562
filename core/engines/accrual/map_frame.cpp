#include "core/engines/accrual/map_frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/engines/accrual/trapezoid.h"

namespace noonmark {

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
