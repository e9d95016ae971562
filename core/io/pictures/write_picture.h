#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// A picture with its position, as files have it: the first row is the northernmost.
struct PlacedPicture {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> rgba;        ///< four bytes a pixel; alpha not multiplied in
    std::string crs;                       ///< "EPSG:3857"
    std::array<double, 6> geoTransform{};  ///< as GDAL has it
    std::string attribution;               ///< the file's tag TIFFTAG_COPYRIGHT
};

/// Writes a tiled, compressed GeoTIFF of four bands, under a temporary name that becomes `file` at the end.
/// Error: the system is unknown, or the file cannot be written. Backend: write_picture_gdal.cpp.
Result<void> writePicture(const std::filesystem::path& file, const PlacedPicture& picture);

}  // namespace noonmark
