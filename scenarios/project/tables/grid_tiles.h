#pragma once

#include <string>
#include <vector>

#include "core/geo/frame.h"
#include "core/geo/grid.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The frame's plane as WKT 1, for GIS. Backend: grid_tiles_gdal.cpp, like all here.
std::string localCrsWkt(const Frame& frame);

/// Cells along a tile's side.
inline constexpr int tileCells = 256;
/// Stands for NaN in tiles.
inline constexpr float tileNoData = -9999;

/// One tile of a grid as a Float32 TIFF, deflated: cells of tile `column`, `row` (from the grid's
/// NORTH-western corner), north first, what lies outside of the grid is tileNoData. Empty where GDAL fails.
Bytes encodeTile(const Grid& grid, const std::vector<float>& values, int column, int row);

/// Puts a tile's cells into `values`. False where the bytes are no such TIFF.
bool decodeTile(std::string_view tiff, const Grid& grid, int column, int row, std::vector<float>& values);

}  // namespace noonmark
