#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geo/grid.h"

namespace noonmark {

/// Position of a point in cells of a grid: the centre of cell (0, 0) is at (0, 0).
inline glm::dvec2 toCells(const Grid& grid, glm::dvec2 local) {
    return {(local.x - grid.westM) / grid.cellM - 0.5, (local.y - grid.southM) / grid.cellM - 0.5};
}

/// Offset, in cells, of the shadow of a point one metre up from the point below it. `towardsSun`: above the
/// horizon.
inline glm::dvec2 shadowOffsetInCells(glm::dvec3 towardsSun, double cellM) {
    return glm::dvec2(towardsSun.x, towardsSun.y) / (-towardsSun.z * cellM);
}

}  // namespace noonmark
