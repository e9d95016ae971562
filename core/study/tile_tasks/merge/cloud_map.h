#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/result.h"

namespace noonmark {

/// Writes a Cloud Optimized GeoTIFF with the bands, cells, names and tags of a GeoTIFF that Noonmark wrote:
/// blocks of 512, DEFLATE, overviews of means. Error: it cannot be written; cancelled(). Backend:
/// cloud_map_gdal.cpp.
Result<void> writeCloudMap(const std::filesystem::path& from, const std::filesystem::path& to,
                           const std::stop_token& stop);

}  // namespace noonmark
