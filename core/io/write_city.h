#pragma once

#include <filesystem>

#include "core/city/city.h"
#include "core/result.h"

namespace noonmark {

/// A GeoPackage (EPSG:4326) with a polygon layer `buildings`: one feature a part, with `building_id` (of its building), `source_id`, `name`, `status`,
/// `height` and `min_height` (metres above the ground), `ground_elevation`, `height_source`, `hangs`. readCity() gives the same city back
/// (coordinates to 1 mm). Parts with meshes are written as their outline and said so in the returned warnings' place: an Error is for files only.
/// Backend: write_city_gdal.cpp.
Result<void> writeCityGeoPackage(const std::filesystem::path& file, const City& city);

}  // namespace noonmark
