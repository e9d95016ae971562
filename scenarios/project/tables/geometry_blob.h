#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The project's own spatial reference system in its file: local metres (docs/project-file.md).
inline constexpr int localSrsId = 100000;

/// GeoPackage geometry of local metres, little-endian, with its envelope. The points are float32 and come
/// back to the last bit.
Bytes polygonBlob(const Footprint& footprint);
Bytes multiPolygonBlob(const std::vector<Footprint>& polygons);

/// The polygons of a POLYGON or MULTIPOLYGON. What another program drew is repaired. Nothing for bytes that
/// are no such geometry.
std::optional<std::vector<Footprint>> toPolygons(std::string_view blob);

}  // namespace noonmark
