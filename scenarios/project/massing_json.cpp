#include "scenarios/project/massing_json.h"

#include <stdexcept>

#include "core/base/json_number.h"
#include "core/city/plausible_heights.h"
#include "scenarios/project/tables/ring_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr NumberLimits storeyLimitsM{2, 10};
constexpr NumberLimits aboveGroundLimitsM{0, tallestBuildingM};
constexpr NumberLimits shareLimits{0, 1};
constexpr NumberLimits areaLimitsM2{0, 1e12};
constexpr NumberLimits turnLimitsDeg{-360, 360};
constexpr int mostStoreys = 500;
constexpr std::size_t mostEntries = 500;  // setbacks or uses of one tower

Json toJson(const PlateSize& plate) {
    Json json = Json::object();
    if (plate.shareOfLot) json["share_of_lot"] = *plate.shareOfLot;
    if (plate.areaM2) json["area_m2"] = *plate.areaM2;
    return json;
}

void addWalls(Json& json, const WallShape& walls) {
    if (walls.taper != 0) json["taper"] = walls.taper;
    if (walls.twistDeg != 0) json["twist_clockwise_deg"] = walls.twistDeg;
}

Json toJson(const Podium& podium) {
    Json json{{"storeys", podium.storeys}, {"plate", toJson(podium.plate)}};
    addWalls(json, podium.walls);
    return json;
}

Json toJson(const Setback& setback) {
    Json json{{"above_m", setback.aboveM}, {"inset_m", setback.insetM}};
    addWalls(json, setback.walls);
    return json;
}

double numberIn(const Json& json, const char* member, const NumberLimits& limits) {
    return json.contains(member) ? numberFrom(json.at(member), limits) : 0;
}

int storeysIn(const Json& json) {
    const int storeys = wholeNumberIn<int>(json, "storeys", 0);
    if (storeys < 0 || storeys > mostStoreys) throw std::invalid_argument("an impossible number of storeys");
    return storeys;
}

PlateSize parsePlate(const Json& json) {
    PlateSize plate;
    if (json.contains("share_of_lot")) plate.shareOfLot = numberFrom(json.at("share_of_lot"), shareLimits);
    if (json.contains("area_m2")) plate.areaM2 = numberFrom(json.at("area_m2"), areaLimitsM2);
    return plate;
}

WallShape parseWalls(const Json& json) {
    return {.taper = numberIn(json, "taper", shareLimits),
            .twistDeg = numberIn(json, "twist_clockwise_deg", turnLimitsDeg)};
}

Setback parseSetback(const Json& json) {
    return {.aboveM = numberFrom(json.at("above_m"), aboveGroundLimitsM),
            .insetM = numberFrom(json.at("inset_m"), aboveGroundLimitsM),
            .walls = parseWalls(json)};
}

// An absent list is empty.
template <class Parse>
auto parseList(const Json& json, const char* member, Parse&& parse) {
    std::vector<decltype(parse(json))> list;
    if (!json.contains(member)) return list;
    if (json.at(member).size() > mostEntries) throw std::invalid_argument("too many entries");
    for (const Json& one : json.at(member)) list.push_back(parse(one));
    return list;
}

MassingSettings parseSettings(const Json& json) {
    MassingSettings settings{.storeyHeightM = numberFrom(json.at("storey_height_m"), storeyLimitsM),
                             .storeys = storeysIn(json),
                             .heightM = numberIn(json, "height_m", aboveGroundLimitsM),
                             .plate = parsePlate(json.at("plate"))};
    if (json.contains("podium")) {
        const Json& podium = json.at("podium");
        settings.podium = Podium{storeysIn(podium), parsePlate(podium.at("plate")), parseWalls(podium)};
    }
    settings.setbacks = parseList(json, "setbacks", parseSetback);
    settings.clockwiseDeg = numberIn(json, "clockwise_deg", turnLimitsDeg);
    settings.walls = parseWalls(json);
    settings.uses = parseList(json, "uses", [](const Json& use) {
        return FloorUse{use.at("use").get<std::string>(), storeysIn(use)};
    });
    return settings;
}

}  // namespace

Json toJson(const TowerDesign& design) {
    const MassingSettings& settings = design.settings;
    Json json{
        {"lot", design.lotName}, {"lot_outer", ringJson(design.lot.outer)}, {"lot_holes", Json::array()}};
    for (const Ring& hole : design.lot.holes) json["lot_holes"].push_back(ringJson(hole));
    json["storey_height_m"] = settings.storeyHeightM;
    if (settings.storeys > 0) json["storeys"] = settings.storeys;
    if (settings.heightM > 0) json["height_m"] = settings.heightM;
    json["plate"] = toJson(settings.plate);
    if (settings.podium) json["podium"] = toJson(*settings.podium);
    for (const Setback& setback : settings.setbacks) json["setbacks"].push_back(toJson(setback));
    if (settings.clockwiseDeg != 0) json["clockwise_deg"] = settings.clockwiseDeg;
    addWalls(json, settings.walls);
    for (const FloorUse& use : settings.uses)
        json["uses"].push_back({{"use", use.use}, {"storeys", use.storeys}});
    return json;
}

DesignOfShape parseDesign(const Json& json) {
    auto design = std::make_shared<TowerDesign>();
    design->lotName = json.at("lot").get<std::string>();
    design->lot.outer = parseRing(json.at("lot_outer"));
    for (const Json& hole : json.at("lot_holes")) design->lot.holes.push_back(parseRing(hole));
    design->settings = parseSettings(json);
    return design;
}

}  // namespace noonmark
