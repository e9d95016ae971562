#include "app/window/reading_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
void put(Json& json, const char* key, const T& value, const T& usual) {
    if (value != usual) json[key] = value;
}

template <class T>
void take(const Json& json, const char* key, T& value) {
    if (json.contains(key)) json.at(key).get_to(value);
}

LengthUnit unitOf(const Json& json) {
    const int unit = json;
    if (unit < 0 || unit > int(LengthUnit::centimetres)) throw std::out_of_range("unit");
    return LengthUnit(unit);
}

Json meshJson(const ReadSettings& reading) {
    const ReadSettings usual;
    Json json = Json::object();
    put(json, "z_up", reading.upAxis == UpAxis::z, false);
    put(json, "mesh_unit", int(reading.meshUnit), int(usual.meshUnit));
    put(json, "mesh_north_deg", reading.meshNorthDeg, usual.meshNorthDeg);
    if (reading.meshAnchor) json["mesh_anchor"] = {reading.meshAnchor->lonDeg, reading.meshAnchor->latDeg};
    return json;
}

void takeMesh(const Json& json, ReadSettings& reading) {
    if (json.value("z_up", false)) reading.upAxis = UpAxis::z;
    if (json.contains("mesh_unit")) reading.meshUnit = unitOf(json.at("mesh_unit"));
    take(json, "mesh_north_deg", reading.meshNorthDeg);
    if (json.contains("mesh_anchor")) {
        const Json& place = json.at("mesh_anchor");
        reading.meshAnchor = LonLat{place.at(0).get<double>(), place.at(1).get<double>()};
    }
}

}  // namespace

QString textOf(const ReadSettings& reading) {
    const ReadSettings usual;
    Json json = meshJson(reading);
    put(json, "height_field", reading.heightField, usual.heightField);
    put(json, "levels_field", reading.levelsField, usual.levelsField);
    if (reading.heightUnit) json["height_unit"] = int(*reading.heightUnit);
    put(json, "metres_per_level", reading.metresPerLevel, usual.metresPerLevel);
    put(json, "default_height_m", reading.defaultHeightM, usual.defaultHeightM);
    put(json, "layer", reading.layer, usual.layer);
    if (reading.crs) json["crs"] = *reading.crs;
    put(json, "lod", reading.lod, usual.lod);
    put(json, "far_away_m", reading.farAwayM, usual.farAwayM);
    put(json, "terrain_from_bases", int(reading.terrainFromBases), int(usual.terrainFromBases));
    return json.empty() ? QString() : QString::fromStdString(json.dump());
}

std::optional<ReadSettings> readingFrom(const QString& text) try {
    ReadSettings reading;
    if (text.isEmpty()) return reading;
    const Json json = Json::parse(text.toStdString());
    takeMesh(json, reading);
    take(json, "height_field", reading.heightField);
    take(json, "levels_field", reading.levelsField);
    if (json.contains("height_unit")) reading.heightUnit = unitOf(json.at("height_unit"));
    take(json, "metres_per_level", reading.metresPerLevel);
    take(json, "default_height_m", reading.defaultHeightM);
    take(json, "layer", reading.layer);
    if (json.contains("crs")) reading.crs = json.at("crs").get<std::string>();
    take(json, "lod", reading.lod);
    take(json, "far_away_m", reading.farAwayM);
    if (json.contains("terrain_from_bases"))
        reading.terrainFromBases = TerrainFromBases(
            std::clamp(json.at("terrain_from_bases").get<int>(), 0, int(TerrainFromBases::never)));
    return reading;
} catch (const std::exception&) {  // no JSON, or of another shape
    return std::nullopt;
}

}  // namespace noonmark
