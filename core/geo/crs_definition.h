#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

class OGRSpatialReference;

namespace noonmark {

/// Reads the definition of a coordinate reference system, which comes from a file or from the user: a code
/// ("EPSG:7415", "urn:ogc:def:crs:EPSG::7415", "https://www.opengis.net/def/crs/EPSG/0/7415"), WKT, PROJJSON
/// or PROJ text of up to 64 KiB. Points are in the order easting, northing or longitude, latitude. Nothing is
/// fetched and no file is opened but PROJ's own. Error: the system is unknown, not one of the earth's
/// surface, or names a file. Backend: crs_definition_gdal.cpp.
Result<OGRSpatialReference> parseCrs(const std::string& text);

/// Error: the definition names a file (of parameters, or a grid) that is not one of PROJ's own. Without it
/// the system would give other places than its author meant.
Result<void> checkNamesNoFile(std::string_view definition);

/// A system that GDAL has read from a file, as WKT, for parseCrs(). Empty if there is none.
std::string wktOf(const OGRSpatialReference* system);

}  // namespace noonmark
