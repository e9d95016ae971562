#include "core/engines/depths/sun_depth_map.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/engines/depths/map_frame.h"
#include "core/engines/depths/slice_stack.h"

namespace noonmark {

namespace {

std::array<glm::vec3, 8> cornersOf(const LitSpace& space) {
    std::array<glm::vec3, 8> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? space.box.high.x : space.box.low.x, i & 2 ? space.box.high.y : space.box.low.y,
                      i & 4 ? space.highM : space.lowM};
    return corners;
}

// At a right angle to the sun, through the middle of the space.
MapFrame frameAcross(const std::array<glm::vec3, 8>& corners, glm::dvec3 towardsSun, int size) {
    MapFrame frame;
    frame.origin = (glm::dvec3(corners.front()) + glm::dvec3(corners.back())) / 2.0;
    frame.normal = towardsSun;
    const glm::dvec3 level = glm::cross(glm::dvec3(0, 0, 1), towardsSun);
    frame.u = glm::length(level) < 1e-6 ? glm::dvec3(1, 0, 0) : glm::normalize(level);
    frame.v = glm::cross(frame.normal, frame.u);
    frame.columns = frame.rows = size;
    std::array<glm::dvec2, 8> feet{};
    std::ranges::transform(corners, feet.begin(), [&](glm::vec3 corner) {
        const glm::dvec3 placed = frame.placed(corner);
        return glm::dvec2(placed.x, placed.y);
    });
    frame.texelFromPlane = fitBox(feet, size);
    return frame;
}

// The scalar product with `axis`, measured from the frame's origin.
glm::dvec4 along(const MapFrame& frame, glm::dvec3 axis, double offset) {
    return {axis, offset - glm::dot(axis, frame.origin)};
}

SunDepthMap placeMap(const MapFrame& frame, int size) {
    SunDepthMap map;
    const glm::dmat3& texel = frame.texelFromPlane;
    map.towardsSun = frame.normal;
    map.size = size;
    map.column = along(frame, texel[0].x * frame.u + texel[1].x * frame.v, texel[2].x);
    map.row = along(frame, texel[0].y * frame.u + texel[1].y * frame.v, texel[2].y);
    map.height = along(frame, frame.normal, 0);
    map.texelM = 1 / std::min(std::abs(texel[0].x), std::abs(texel[1].y));
    map.depth.resize(std::size_t(size) * std::size_t(size));
    return map;
}

// Rows `first` up to `end` of the map. Each band is drawn by itself, so that bands can be drawn in parallel.
void drawBand(const IntervalCasters& casters, MapFrame frame, int first, int end, SunDepthMap& map) {
    frame.rows = end - first;
    frame.texelFromPlane[2].y -= first;
    DepthSlice slice(frame.columns, frame.rows);
    SliceDrawer().draw(casters, frame, {0, 0}, CasterSide::awayFromSun, slice);
    for (int row = 0; row < frame.rows; ++row) {
        const auto from = slice.depth.begin() + std::ptrdiff_t(row) * slice.stride;
        std::copy_n(from, map.size, map.depth.begin() + std::ptrdiff_t(first + row) * map.size);
    }
}

}  // namespace

bool SunDepthMap::shades(glm::dvec3 point, double biasM) const {
    const glm::dvec4 at(point, 1);
    const auto x = std::lround(glm::dot(column, at)), y = std::lround(glm::dot(row, at));
    if (x < 0 || y < 0 || x >= size || y >= size) return false;
    return depth[std::size_t(y) * std::size_t(size) + std::size_t(x)] > glm::dot(height, at) + biasM;
}

SunDepthMap drawSunDepths(const CasterFaces& faces, glm::dvec3 towardsSun, const LitSpace& space, int size,
                          const std::stop_token& stop) {
    const auto corners = cornersOf(space);
    const MapFrame frame = frameAcross(corners, towardsSun, size);
    SunDepthMap map = placeMap(frame, size);
    double lowest = std::numeric_limits<double>::max();
    for (const glm::vec3 corner : corners) lowest = std::min(lowest, frame.placed(corner).z);
    const IntervalCasters casters =
        placeCasters(faces, frame.placed(faces.points), frame, {towardsSun, towardsSun, 1},
                     CasterSide::awayFromSun, {lowest, {}});
    const int bands = std::clamp(tbb::this_task_arena::max_concurrency(), 1, 8);
    tbb::parallel_for(0, bands, [&](int band) {
        if (!stop.stop_requested())
            drawBand(casters, frame, size * band / bands, size * (band + 1) / bands, map);
    });
    return map;
}

}  // namespace noonmark
