#pragma once

#include <string>

#include "core/receivers/region.h"

namespace noonmark {

/// Reads a region: "W,S,E,N" in degrees, "POLYGON ((lon lat, ...))" or MULTIPOLYGON in degrees, or the path
/// of a polygon file (any vector format that GDAL knows, any CRS; all polygons of all its layers together,
/// repaired if invalid). Long sides in the file's CRS get extra points, so that they follow the curves of the
/// projection. Error: none of these, no polygon, no CRS, coordinates that cannot belong to the CRS, or a
/// place more than 200 km from the frame's origin. Backend: read_region_gdal.cpp.
Result<Region> readRegion(const std::string& boxOrFile, const Frame& frame);

}  // namespace noonmark
