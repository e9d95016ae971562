#pragma once

#include <string>
#include <vector>

#include "core/geo/frame.h"
#include "core/geo/grid.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The local coordinate system as WKT 1, for GIS programs. Backend of this header: grid_tiles_gdal.cpp.
std::string localCrsWkt(const Frame& frame);

/// Cells per side of a tile.
inline constexpr int tileCells = 256;
/// Replaces NaN in tiles.
inline constexpr float tileNoData = -9999;

/// Encodes one tile of a grid as a deflated Float32 TIFF. Tiles count from the grid's NORTH-western corner,
/// rows run from north to south, and cells outside the grid are tileNoData. Empty where GDAL fails.
Bytes encodeTile(const Grid& grid, const std::vector<float>& values, int column, int row);

/// Copies the cells of a tile into `values`. False where the bytes are not such a TIFF.
bool decodeTile(std::string_view tiff, const Grid& grid, int column, int row, std::vector<float>& values);

}  // namespace noonmark
