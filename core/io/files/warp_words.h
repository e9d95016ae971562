#pragma once

#include <string>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// Words for GDAL's warper that every resampling of a raster shares: from one coordinate reference system
/// into the cells of a grid in another, in memory, heights left alone, with 256 MB to work in.
std::vector<std::string> makeWarpWords(const std::string& fromCrs, const std::string& toCrs,
                                       const Grid& grid);

}  // namespace noonmark
