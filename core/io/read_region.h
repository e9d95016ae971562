#pragma once

#include <string>

#include "core/receivers/region.h"

namespace noonmark {

/// "W,S,E,N" in degrees, or the path of a polygon file (any vector format, any CRS; all its polygons are the region).
/// Backend: read_region_gdal.cpp.
Result<Region> readRegion(const std::string& boxOrFile, const Frame& frame);

}  // namespace noonmark
