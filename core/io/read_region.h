#pragma once

#include <string>

#include "core/receivers/region.h"

namespace noonmark {

/// "W,S,E,N" in degrees, "POLYGON ((lon lat, ...))" or MULTIPOLYGON in degrees, or the path of a polygon file
/// (any vector format GDAL knows, any CRS; all polygons of all its layers are the region, repaired where they
/// are invalid). Long sides in the file's CRS are bent as the projection bends them. Error: none of these, no
/// polygon, no CRS, coordinates that the CRS cannot have, or a place more than 200 km from the frame's
/// origin. Backend: read_region_gdal.cpp.
Result<Region> readRegion(const std::string& boxOrFile, const Frame& frame);

}  // namespace noonmark
