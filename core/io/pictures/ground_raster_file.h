#pragma once

// The folder core/io/pictures reads pictures of the ground: rasters of colours with a position.

#include <array>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/city/map_context.h"
#include "core/geo/frame.h"

namespace noonmark {

struct GroundRasterSettings {
    int maxPixels = 4096;  ///< longest side of what is read, 1 to 8192: 64 MB at 4096
    double finestM = 0.1;  ///< side of a cell, the least; above 0
};

/// Reads the part of a GeoTIFF or an Erdas Imagine file that lies in `box` (local metres), reprojected into
/// the frame: one band (grey or with a colour table), three bands or more (red, green, blue first), of 8
/// bits; a band of transparency and missing values count. A cell is as large as the box and maxPixels make
/// it, but not finer than finestM. Memory: the result, and 256 MB for reprojection. Error: not such a file,
/// damaged, without position or coordinate reference system, not of 8 bits, more than 2e10 pixels, or all of
/// it outside of the box; cancelled(). Some seconds for 1e9 pixels without overviews. Backend:
/// ground_raster_file_gdal.cpp.
Result<GroundRaster> readGroundRaster(const std::filesystem::path& file, const Frame& frame, const Box2& box,
                                      const GroundRasterSettings& settings, Progress& progress,
                                      const std::stop_token& stop);

/// Whether a file is of a format of readGroundRaster(), with three or more bands of 8 bits, or one with a
/// table of colours: a picture and no terrain. Reads its head only.
bool isGroundPicture(const std::filesystem::path& file);

/// A picture with its position, as files have it: the first row is the northernmost.
struct PlacedPicture {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> rgba;        ///< four bytes a pixel; alpha not multiplied in
    std::string crs;                       ///< "EPSG:3857"
    std::array<double, 6> geoTransform{};  ///< as GDAL has it
    std::string attribution;               ///< the file's tag TIFFTAG_COPYRIGHT
};

/// Writes a tiled, compressed GeoTIFF of four bands, under a temporary name that becomes `file` at the end.
/// Error: the system is unknown, or the file cannot be written. Backend: ground_raster_file_gdal.cpp.
Result<void> writePicture(const std::filesystem::path& file, const PlacedPicture& picture);

}  // namespace noonmark
