#include "core/io/settings/read_settings.h"

#include <cmath>
#include <vector>

#include "core/describe/command_options.h"
#include "core/describe/field_json.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

std::vector<Choice<LengthUnit>> makeUnitChoices() {
    std::vector<Choice<LengthUnit>> choices;
    for (const LengthUnitEntry& entry : listLengthUnits())
        choices.push_back({entry.unit, entry.key, entry.plural});
    return choices;
}

std::span<const Choice<LengthUnit>> unitChoices() {
    static const std::vector<Choice<LengthUnit>> choices = makeUnitChoices();
    return choices;
}

constexpr std::array basesChoices{
    Choice{TerrainFromBases::automatic, "auto", NM_TEXT("if neighbours' ground heights differ")},
    Choice{TerrainFromBases::always, "always", NM_TEXT("always")},
    Choice{TerrainFromBases::never, "never", NM_TEXT("never (flat ground)")}};

constexpr std::array standChoices{
    Choice{Stand::automatic, "auto", NM_TEXT("as their bases fit the terrain")},
    Choice{Stand::terrain, "terrain", NM_TEXT("each set down on the terrain")},
    Choice{Stand::absolute, "absolute", NM_TEXT("at the elevations in the file")}};

constexpr std::array showsChoices{
    Choice{TerrainShows::automatic, "auto", NM_TEXT("found by its steps at outlines")},
    Choice{TerrainShows::ground, "ground", NM_TEXT("the bare ground")},
    Choice{TerrainShows::surface, "surface", NM_TEXT("a surface with buildings")}};

constexpr std::array axisChoices{Choice{UpAxis::automatic, "auto", NM_TEXT("Automatic")},
                                 Choice{UpAxis::y, "y", NM_TEXT("Y")}, Choice{UpAxis::z, "z", NM_TEXT("Z")}};

Value getAnchor(const ReadSettings& settings) {
    if (!settings.meshAnchor) return {};
    return std::vector{settings.meshAnchor->lonDeg, settings.meshAnchor->latDeg};
}

Result<void> setAnchor(ReadSettings& settings, const Value& value) {
    if (value == Value()) {
        settings.meshAnchor.reset();
        return {};
    }
    const auto* place = std::get_if<std::vector<double>>(&value);
    const bool isPlace =
        place && place->size() == 2 && std::abs(place->front()) <= 180 && std::abs(place->back()) <= 90;
    if (!isPlace)
        return failure("This is not a position on the earth", "mesh-anchor",
                       "Give LON,LAT in degrees, for example -73.98,40.75");
    settings.meshAnchor = LonLat{place->front(), place->back()};
    return {};
}

Value getExtent(const ReadSettings& settings) {
    if (!settings.extent) return {};
    const LonLatBox& box = *settings.extent;
    return std::vector{box.westDeg, box.southDeg, box.eastDeg, box.northDeg};
}

Result<void> setExtent(ReadSettings& settings, const Value& value) {
    if (value == Value()) {
        settings.extent.reset();
        return {};
    }
    const auto* sides = std::get_if<std::vector<double>>(&value);
    const auto isBox = [](const LonLatBox& box) {
        return box.westDeg >= -180 && box.eastDeg <= 180 && box.southDeg >= -90 && box.northDeg <= 90 &&
               box.westDeg < box.eastDeg && box.southDeg < box.northDeg;
    };
    if (sides != nullptr && sides->size() == 4)
        if (const LonLatBox box{sides->at(0), sides->at(1), sides->at(2), sides->at(3)}; isBox(box)) {
            settings.extent = box;
            return {};
        }
    return failure("This is no box on earth", "extent",
                   "Give west,south,east,north in degrees, for example -73.99,40.75,-73.97,40.77");
}

Fields<ReadSettings> heightFields() {
    return {
        field(&ReadSettings::heightField,
              {.key = "height_field",
               .flag = "--height-field",
               .label = NM_TEXT("Height field"),
               .help = NM_TEXT("Field with the heights (default: found by its name)"),
               .hint = "NAME",
               .whenEmpty = NM_TEXT("found by name")}),
        field(&ReadSettings::levelsField,
              {.key = "levels_field",
               .flag = "--levels-field",
               .label = NM_TEXT("Storeys field"),
               .help = NM_TEXT("Field with the storeys above the ground (default: found by its name)"),
               .hint = "NAME",
               .whenEmpty = NM_TEXT("found by name")}),
        field(&ReadSettings::nameField,
              {.key = "building_name_field",
               .flag = "--building-name-field",
               .label = NM_TEXT("Names field"),
               .help = NM_TEXT("Field with the names of the buildings (default: found by its name)"),
               .hint = "NAME",
               .whenEmpty = NM_TEXT("found by name")}),
        choiceField(&ReadSettings::heightUnit, unitChoices(),
                    {.key = "height_unit",
                     .flag = "--height-unit",
                     .label = NM_TEXT("Unit of heights"),
                     .help = NM_TEXT("Unit of numbers without a unit in it: m, ft, us-ft, dm, cm, mm or in "
                                     "(default m)"),
                     .hint = "UNIT",
                     .whenEmpty = NM_TEXT("as in the file")}),
        field(&ReadSettings::metresPerLevel, {.key = "metres_per_level",
                                              .flag = "--metres-per-level",
                                              .label = NM_TEXT("Height of a storey"),
                                              .help = NM_TEXT("Height of a storey, 2 to 6 m"),
                                              .unit = "m",
                                              .range = ValueRange{2, 6}}),
        field(&ReadSettings::defaultHeightM,
              {.key = "default_height_m",
               .flag = "--default-height",
               .label = NM_TEXT("Default height"),
               .help = NM_TEXT("Height of buildings without height data, 1 to 1000 m"),
               .unit = "m",
               .range = ValueRange{1, 1000}}),
    };
}

Fields<ReadSettings> terrainFields() {
    return {
        choiceField(&ReadSettings::terrainFromBases, basesChoices,
                    {.key = "terrain_from_bases",
                     .flag = "--terrain-from-bases",
                     .label = NM_TEXT("Terrain from building bases"),
                     .help = NM_TEXT("If there is no terrain, derive one from the ground elevations of the "
                                     "buildings; auto (default): only where neighbours stand at different "
                                     "heights"),
                     .hint = "WHEN"}),
        choiceField(&ReadSettings::terrainShows, showsChoices,
                    {.key = "terrain_shows",
                     .flag = "--terrain-shows",
                     .label = NM_TEXT("Terrain shows"),
                     .help = NM_TEXT("What terrain rasters show: the bare ground, or a surface with the "
                                     "buildings on it; auto (default): a surface where they jump at the "
                                     "outlines of buildings"),
                     .hint = "WHAT"}),
        field(
            &ReadSettings::heightsFromSurface,
            {.key = "heights_from_surface",
             .flag = "--heights-from-surface",
             .label = NM_TEXT("Missing heights from the surface model"),
             .help = NM_TEXT("Give buildings without a height that of the surface model above the ground")}),
        field(&ReadSettings::surfaceToleranceM,
              {.key = "surface_tolerance_m",
               .flag = "--surface-tolerance",
               .label = NM_TEXT("Tolerance of buildings from a surface model"),
               .help = NM_TEXT("How far buildings that are made of a surface model may lie above or below "
                               "its cells, 0.05 to 5 m"),
               .unit = "m",
               .range = ValueRange{0.05, 5}}),
    };
}

Fields<ReadSettings> dataFields() {
    return {
        field(&ReadSettings::layer, {.key = "layer",
                                     .flag = "--layer",
                                     .label = NM_TEXT("Layer"),
                                     .help = NM_TEXT("Read this layer only"),
                                     .hint = "NAME",
                                     .whenEmpty = NM_TEXT("the polygon layers that hold buildings")}),
        field(&ReadSettings::crs,
              {.key = "crs",
               .flag = "--crs",
               .label = NM_TEXT("Coordinate system"),
               .help = NM_TEXT("Coordinate reference system of files that do not state it: EPSG:2263"),
               .hint = "CRS",
               .whenEmpty = NM_TEXT("as in the file (example: EPSG:2263)")}),
        field(&ReadSettings::treeFiles,
              {.key = "trees",
               .flag = "--trees",
               .label = NM_TEXT("Inventories of trees"),
               .help = NM_TEXT("File with trees beside those of the city's files: points or a table with "
                               "species, height, crown or stem; may be repeated"),
               .hint = "FILE"}),
        field(&ReadSettings::lod,
              {.key = "lod",
               .flag = "--lod",
               .label = NM_TEXT("Level of detail"),
               .help = NM_TEXT("CityGML, CityJSON: level of detail (default: the highest)"),
               .hint = "LOD",
               .whenEmpty = NM_TEXT("the highest")}),
        field(&ReadSettings::farAwayM,
              {.key = "far_away_m",
               .flag = "--far-away",
               .label = NM_TEXT("Maximum distance"),
               .help = NM_TEXT("Leave out features farther than this from the middle of the data, m"),
               .unit = "m",
               .range = ValueRange{100, 200000}}),
        derivedField(ValueKind::numbers, &getExtent, &setExtent,
                     {.key = "extent",
                      .flag = "--extent",
                      .label = NM_TEXT("Extent"),
                      .help = NM_TEXT("Read only the buildings that touch this box, degrees; terrain is read "
                                      "whole"),
                      .hint = "W,S,E,N"}),
    };
}

Fields<ReadSettings> meshPlaceFields() {
    return {
        field(
            &ReadSettings::meshNorthDeg,
            {.key = "mesh_north_deg",
             .flag = "--mesh-north",
             .label = NM_TEXT("Mesh north"),
             .help = NM_TEXT("Meshes: azimuth of the mesh's north axis from true north, clockwise, degrees"),
             .unit = "deg",
             .range = ValueRange{-360, 360}}),
        derivedField(ValueKind::numbers, &getAnchor, &setAnchor,
                     {.key = "mesh_anchor",
                      .flag = "--mesh-anchor",
                      .label = NM_TEXT("Origin located at"),
                      .help = NM_TEXT("Meshes: position of the mesh's origin, degrees"),
                      .hint = "LON,LAT"}),
    };
}

}  // namespace

const Fields<ReadSettings>& standFields() {
    static const Fields<ReadSettings> fields{choiceField(
        &ReadSettings::stand, standChoices,
        {.key = "stand",
         .flag = "--stand",
         .label = NM_TEXT("Buildings stand"),
         .help =
             NM_TEXT("Where buildings stand: each on the terrain, or at the elevations that the file states "
                     "(absolute); auto (default): as its bases lie against the terrain"),
         .hint = "HOW"})};
    return fields;
}

const Fields<ReadSettings>& meshAxesFields() {
    static const Fields<ReadSettings> fields{
        choiceField(&ReadSettings::upAxis, axisChoices,
                    {.key = "up",
                     .flag = "--up",
                     .label = NM_TEXT("Up axis"),
                     .help = NM_TEXT("Meshes: the axis that points up, y or z; auto (default): as the format "
                                     "says or the shape suggests"),
                     .hint = "AXIS"}),
        choiceField(
            &ReadSettings::meshUnit, unitChoices(),
            {.key = "mesh_unit",
             .flag = "--mesh-unit",
             .label = NM_TEXT("Unit of coordinates"),
             .help = NM_TEXT("Meshes: unit of the coordinates: m, ft, us-ft, dm, cm, mm or in (default m)"),
             .hint = "UNIT"}),
    };
    return fields;
}

const Fields<ReadSettings>& readSettingsFields() {
    static const auto fields = heightFields()
                                   .with(dataFields())
                                   .with(terrainFields())
                                   .with(standFields())
                                   .with(meshAxesFields())
                                   .with(meshPlaceFields());
    return fields;
}

std::string readOption(std::string_view key, std::string_view value) {
    std::string option(flagOf(readSettingsFields().rows(), key));
    if (!value.empty()) option.append(" ").append(value);
    return option;
}

namespace {

using Json = nlohmann::ordered_json;

// Projects name the axis by whether z points up, as all versions read it.
constexpr const char* axisKey = "z_up";

void readAxis(Json& json) {
    const auto found = json.find(axisKey);
    if (found == json.end()) return;
    json["up"] = found->get<bool>() ? "z" : "y";
    json.erase(axisKey);
}

}  // namespace

std::string formatText(const ReadSettings& reading) {
    Json json = fieldsJson(readSettingsFields().of(reading),
                           {FieldJson::Which::changed, FieldJson::Choices::numbers});
    json.erase("up");
    if (reading.upAxis != UpAxis::automatic) json[axisKey] = reading.upAxis == UpAxis::z;
    return json.empty() ? std::string() : json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ReadSettings> readSettingsFrom(const std::string& text) try {
    ReadSettings reading;
    if (text.empty()) return reading;
    Json json = Json::parse(text);
    readAxis(json);
    if (!readFieldsJson(readSettingsFields().of(reading), json)) return std::nullopt;
    return reading;
} catch (const std::exception&) {  // not JSON, or of another structure
    return std::nullopt;
}

}  // namespace noonmark
