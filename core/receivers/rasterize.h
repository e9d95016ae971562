#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/grid.h"

namespace noonmark {

/// Calls `fill(row, firstColumn, endColumn)` for every run of cells whose centres lie in the footprint, by
/// the half-open rule of `contains`: footprints that share an edge never share a cell. Crossings are computed
/// in double; rings may have any orientation (even-odd). O(edges x rows they span).
void forEachRun(const Footprint& footprint, const Grid& grid,
                const std::function<void(int row, int firstColumn, int endColumn)>& fill);

/// The cells whose centres lie in any of the footprints, by the same rule, ascending and each once.
/// O(k log k) for k cells, beside forEachRun() for each footprint.
std::vector<std::uint32_t> collectCells(const std::vector<Footprint>& footprints, const Grid& grid);

}  // namespace noonmark
