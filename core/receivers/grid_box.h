#pragma once

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// Whether a box intersects the cells of a grid, edges included.
inline bool overlaps(const Box2& box, const Grid& grid) {
    return !box.empty() && double(box.low.x) <= grid.eastM() && double(box.high.x) >= grid.westM &&
           double(box.low.y) <= grid.northM() && double(box.high.y) >= grid.southM;
}

/// The square of a cell, by its number in grid order.
inline Box2 cellBox(const Grid& grid, std::size_t cell) {
    const glm::vec2 low(float(grid.westM + double(cell % std::size_t(grid.columns)) * grid.cellM),
                        float(grid.southM + double(cell / std::size_t(grid.columns)) * grid.cellM));
    return {low, low + float(grid.cellM)};
}

}  // namespace noonmark
