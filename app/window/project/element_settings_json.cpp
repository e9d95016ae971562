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
    return fits(facades.bayM) && fits(facades.storeyM) && facades.aboveFloorM >= 0 &&
           facades.aboveFloorM <= FacadeSettings::mostM && elements.planeHeightM >= 0 &&
           elements.planeHeightM <= mostPlaneHeightM;
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
            {"plane_height_m", elements.planeHeightM}};
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
    return areInRange(elements) ? std::optional(elements) : std::nullopt;
} catch (const Json::exception&) {  // of another structure
    return std::nullopt;
}

}  // namespace noonmark
