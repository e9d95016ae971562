#pragma once

#include <cstdint>
#include <span>

#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/projected/step_lanes.h"

namespace noonmark {

/// Fills a shape at eight steps into their bit rasters over some rows of a grid: the eight words of the same
/// cells lie together, in the order of the layout. The centre of cell (column, row) is at (column, row), so
/// that it is filled by the same half-open rule as everywhere (core/city/crossing.h), to rounding in double.
/// The same bits on every instruction set and in every band.
///
/// The shape lies within 10^8 of the raster; what lies off it is clipped. Rows where all words around it are
/// set already are passed over. Returns the number of rows looked at. Cost: 20 ns, and up to 10 ns a row.
int fillShape(const StepShape& shape, const BitLayout& layout, const RowBand& band,
              std::span<std::uint64_t> rasters);

}  // namespace noonmark
