#pragma once

#include <cstdint>
#include <functional>
#include <vector>

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

/// Calls `fill(row, firstColumn, endColumn)` for every run of cells whose centres lie in the footprint, by
/// the half-open rule of `contains`: footprints that share an edge never share a cell. Crossings are computed
/// in double; rings may have any orientation (even-odd). O(edges x rows they span).
void forEachRun(const Footprint& footprint, const Grid& grid,
                const std::function<void(int row, int firstColumn, int endColumn)>& fill);

/// The cells whose centres lie in any of the footprints, by the same rule, ascending and each once.
/// O(k log k) for k cells, beside forEachRun() for each footprint.
std::vector<std::uint32_t> collectCells(const std::vector<Footprint>& footprints, const Grid& grid);

}  // namespace noonmark
