#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geo/frame.h"
#include "core/receivers/grid.h"
#include "core/result.h"

namespace noonmark {

/// One band of a raster file.
struct RasterBand {
    std::string name;                 ///< "gross shadow"
    std::string unit;                 ///< "min/day"
    const std::vector<float>* values; ///< grid order (row 0 south); NaN = nodata. Not owned; outlives the call.
};

/// A tiled, deflate-compressed Float32 GeoTIFF with overviews, in the frame's own projection, nodata NaN, row 0 north as GIS expects. Written
/// beside the target and renamed, so that a killed process leaves no half file. Backend: write_raster_gdal.cpp.
Result<void> writeGeoTiff(const std::filesystem::path& file, const Frame& frame, const Grid& grid,
                          const std::vector<RasterBand>& bands);

}  // namespace noonmark
