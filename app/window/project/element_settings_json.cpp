#include "app/window/project/element_settings_json.h"

#include <algorithm>

#include "core/receivers/points/plane_points.h"

namespace noonmark {

namespace {

using Json = nlohmann::json;

bool areInRange(const ElementSettings& elements) {
    const FacadeSettings& facades = elements.facades;
    const auto fits = [](double metres) {
        return metres >= FacadeSettings::leastM && metres <= FacadeSettings::mostM;
    };
    const auto isBetween = [](double value, double low, double high) {
        return value >= low && value <= high;
    };
    const LineSettings& lines = elements.lines;
    const bool linesFit =
        isBetween(lines.spacingM, LineSettings::leastSpacingM, LineSettings::mostSpacingM) &&
        std::ranges::all_of(lines.offsetsM, [&](double offset) {
            return isBetween(offset, LineSettings::leastOffsetM, LineSettings::mostOffsetM);
        });
    return linesFit && isBetween(elements.faces.withinM, 1, FaceChoice::mostWithinM) && fits(facades.bayM) &&
           fits(facades.storeyM) && facades.aboveFloorM >= 0 &&
           facades.aboveFloorM <= FacadeSettings::mostM && elements.planeHeightM >= 0 &&
           elements.planeHeightM <= mostPlaneHeightM;
}

// What projects of earlier versions lack.
void readLater(const Json& json, ElementSettings& elements) {
    const ElementSettings usual;
    elements.proposed = json.value("proposed", usual.proposed);
    elements.faces.faces = json.value("faces", usual.faces.faces);
    elements.faces.place = json.value("facing_place", usual.faces.place);
    elements.faces.withinM = json.value("within_m", usual.faces.withinM);
    elements.parcel = json.value("parcel", usual.parcel);
    elements.lines.offsetsM = json.value("offsets_m", usual.lines.offsetsM);
    elements.lines.spacingM = json.value("spacing_m", usual.lines.spacingM);
    if (const auto range = parseAzimuthRange(json.value("facing_deg", std::string())))
        elements.faces.facing = *range;
    if (auto points = parsePointList(json.value("points", std::string()), "points"))
        elements.points = *std::move(points);
}

}  // namespace

Json elementSettingsJson(const ElementSettings& elements) {
    return {{"places", nameOf(elements.places)},
            {"buildings", elements.buildings},
            {"bay_m", elements.facades.bayM},
            {"storey_m", elements.facades.storeyM},
            {"above_floor_m", elements.facades.aboveFloorM},
            {"windows", elements.windows.string()},
            {"window_id", elements.windowFile.idField},
            {"windows_crs", elements.windowFile.crs.value_or("")},
            {"windows_above_ground", elements.windowFile.aboveGround},
            {"plane_height_m", elements.planeHeightM},
            {"proposed", elements.proposed},
            {"faces", elements.faces.faces},
            {"facing_deg", elements.faces.facing ? formatText(*elements.faces.facing) : std::string()},
            {"facing_place", elements.faces.place},
            {"within_m", elements.faces.withinM},
            {"parcel", elements.parcel},
            {"offsets_m", elements.lines.offsetsM},
            {"spacing_m", elements.lines.spacingM},
            {"points", elements.points.empty() ? std::string() : toCsv(elements.points)}};
}

std::optional<ElementSettings> elementSettingsFrom(const Json& json) try {
    ElementSettings elements;
    const auto places = std::ranges::find(allElementPlaces, json.at("places").get<std::string>(),
                                          [](ElementPlaces one) { return nameOf(one); });
    if (places == allElementPlaces.end()) return std::nullopt;
    elements.places = *places;
    elements.buildings = json.at("buildings").get<std::vector<std::string>>();
    elements.facades = {json.at("bay_m"), json.at("storey_m"), json.at("above_floor_m")};
    elements.windows = json.at("windows").get<std::string>();
    elements.windowFile.idField = json.at("window_id");
    if (const std::string crs = json.at("windows_crs"); !crs.empty()) elements.windowFile.crs = crs;
    elements.windowFile.aboveGround = json.at("windows_above_ground");
    elements.planeHeightM = json.at("plane_height_m");
    readLater(json, elements);
    return areInRange(elements) ? std::optional(elements) : std::nullopt;
} catch (const Json::exception&) {  // of another structure
    return std::nullopt;
}

}  // namespace noonmark
