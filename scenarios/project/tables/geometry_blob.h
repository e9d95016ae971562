#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Id of the project's own spatial reference system: local metres (docs/project-file.md).
inline constexpr int localSrsId = 100000;

/// GeoPackage geometry in local metres, little-endian, with its envelope. Points are float32 and round-trip
/// exactly.
Bytes polygonBlob(const Footprint& footprint);
Bytes multiPolygonBlob(const std::vector<Footprint>& polygons);

/// A LINESTRING of two or more points.
Bytes lineBlob(const std::vector<glm::vec2>& points);
Bytes pointBlob(glm::vec2 point);
Bytes multiPointBlob(const std::vector<glm::vec2>& points);

/// Parses a POLYGON or MULTIPOLYGON and repairs polygons that another program drew. Empty where the bytes are
/// not such a geometry.
std::optional<std::vector<Footprint>> toPolygons(std::string_view blob);
/// The points of a LINESTRING, a POINT or a MULTIPOINT. Empty where the bytes are no such geometry.
std::optional<std::vector<glm::vec2>> toPoints(std::string_view blob);

/// A ring as [[x, y], ...] in local metres; it round-trips exactly.
nlohmann::ordered_json ringJson(const Ring& ring);

/// Throws nlohmann's exceptions, or std::invalid_argument for fewer than three points.
Ring parseRing(const nlohmann::ordered_json& json);

/// Throws nlohmann's exceptions where the value is not a number, std::invalid_argument where it is out of
/// range.
double numberFrom(const nlohmann::ordered_json& json, const NumberLimits& limits);

}  // namespace noonmark
