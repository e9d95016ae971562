#include "core/accumulate/accrual/map_frame.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace noonmark {

glm::dvec3 MapFrame::placed(glm::vec3 point) const {
    const glm::dvec3 from = glm::dvec3(point) - origin;
    return {glm::dot(from, u), glm::dot(from, v), glm::dot(from, normal)};
}

glm::dvec2 MapFrame::shearOf(glm::dvec3 towardsSun) const {
    return glm::dvec2(glm::dot(towardsSun, u), glm::dot(towardsSun, v)) / glm::dot(towardsSun, normal);
}

MapFrame groundFrame(const Grid& grid, int mapSize, bool texelsOnCells) {
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

}  // namespace noonmark
