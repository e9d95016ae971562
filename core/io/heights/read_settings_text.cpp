#include "core/io/heights/read_settings_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/json_number.h"
#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
void putUnusual(Json& json, const char* key, const T& value, const T& usual) {
    if (value != usual) json[key] = value;
}

template <class T>
void takeStated(const Json& json, const char* key, T& value) {
    if (json.contains(key)) json.at(key).get_to(value);
}

template <class Choice>
void takeChoice(const Json& json, const char* key, Choice& choice, Choice last) {
    if (json.contains(key)) choice = Choice(std::clamp(wholeNumberFrom<int>(json.at(key)), 0, int(last)));
}

LengthUnit lengthUnitOf(const Json& json) {
    const int unit = wholeNumberFrom<int>(json);
    if (unit < 0 || unit >= int(listLengthUnits().size())) throw std::out_of_range("unit");
    return LengthUnit(unit);
}

Json meshSettingsJson(const ReadSettings& reading) {
    const ReadSettings usual;
    Json json = Json::object();
    if (reading.upAxis != UpAxis::automatic) json["z_up"] = reading.upAxis == UpAxis::z;
    putUnusual(json, "mesh_unit", int(reading.meshUnit), int(usual.meshUnit));
    putUnusual(json, "mesh_north_deg", reading.meshNorthDeg, usual.meshNorthDeg);
    if (reading.meshAnchor) json["mesh_anchor"] = {reading.meshAnchor->lonDeg, reading.meshAnchor->latDeg};
    return json;
}

void takeMeshSettings(const Json& json, ReadSettings& reading) {
    if (json.contains("z_up")) reading.upAxis = json.at("z_up").get<bool>() ? UpAxis::z : UpAxis::y;
    if (json.contains("mesh_unit")) reading.meshUnit = lengthUnitOf(json.at("mesh_unit"));
    takeStated(json, "mesh_north_deg", reading.meshNorthDeg);
    if (json.contains("mesh_anchor")) {
        const Json& place = json.at("mesh_anchor");
        reading.meshAnchor = LonLat{place.at(0).get<double>(), place.at(1).get<double>()};
    }
}

}  // namespace

std::string formatText(const ReadSettings& reading) {
    const ReadSettings usual;
    Json json = meshSettingsJson(reading);
    putUnusual(json, "height_field", reading.heightField, usual.heightField);
    putUnusual(json, "levels_field", reading.levelsField, usual.levelsField);
    if (reading.heightUnit) json["height_unit"] = int(*reading.heightUnit);
    putUnusual(json, "metres_per_level", reading.metresPerLevel, usual.metresPerLevel);
    putUnusual(json, "default_height_m", reading.defaultHeightM, usual.defaultHeightM);
    putUnusual(json, "layer", reading.layer, usual.layer);
    if (reading.crs) json["crs"] = *reading.crs;
    putUnusual(json, "lod", reading.lod, usual.lod);
    putUnusual(json, "far_away_m", reading.farAwayM, usual.farAwayM);
    putUnusual(json, "terrain_from_bases", int(reading.terrainFromBases), int(usual.terrainFromBases));
    putUnusual(json, "stand", int(reading.stand), int(usual.stand));
    putUnusual(json, "terrain_shows", int(reading.terrainShows), int(usual.terrainShows));
    putUnusual(json, "heights_from_surface", reading.heightsFromSurface, usual.heightsFromSurface);
    return json.empty() ? std::string() : json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ReadSettings> readSettingsFrom(const std::string& text) try {
    ReadSettings reading;
    if (text.empty()) return reading;
    const Json json = Json::parse(text);
    if (!json.is_object()) return std::nullopt;
    takeMeshSettings(json, reading);
    takeStated(json, "height_field", reading.heightField);
    takeStated(json, "levels_field", reading.levelsField);
    if (json.contains("height_unit")) reading.heightUnit = lengthUnitOf(json.at("height_unit"));
    takeStated(json, "metres_per_level", reading.metresPerLevel);
    takeStated(json, "default_height_m", reading.defaultHeightM);
    takeStated(json, "layer", reading.layer);
    if (json.contains("crs")) reading.crs = json.at("crs").get<std::string>();
    takeStated(json, "lod", reading.lod);
    takeStated(json, "far_away_m", reading.farAwayM);
    takeChoice(json, "terrain_from_bases", reading.terrainFromBases, TerrainFromBases::never);
    takeChoice(json, "stand", reading.stand, Stand::absolute);
    takeChoice(json, "terrain_shows", reading.terrainShows, TerrainShows::surface);
    takeStated(json, "heights_from_surface", reading.heightsFromSurface);
    return reading;
} catch (const std::exception&) {  // not JSON, or of another structure
    return std::nullopt;
}

}  // namespace noonmark
