#pragma once

#include <filesystem>
#include <stop_token>
#include <vector>

#include "core/io/footprints/footprint_scan.h"

namespace noonmark {

/// As listMapLayers(), the layers of points of a map, and its tables, as far as their first feature shows.
/// Backend: footprint_scan_gdal.cpp.
Result<std::vector<ListedLayer>> listPointLayers(const std::filesystem::path& file, std::stop_token stop);

}  // namespace noonmark
