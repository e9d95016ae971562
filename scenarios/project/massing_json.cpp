#include "scenarios/project/massing_json.h"

#include <stdexcept>

#include "core/describe/field_checks.h"
#include "core/describe/field_json.h"
#include "scenarios/massing/massing_fields.h"
#include "scenarios/project/tables/ring_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t maxEntries = 500;  // setbacks or uses of one tower

template <class S>
Json partJson(const Fields<S>& fields, const S& settings) {
    return fieldsJson(fields.of(settings), {.which = FieldJson::Which::stated});
}

// With its plate, even where that is the whole lot.
template <class S>
Json withPlate(Json json, const Fields<S>& fields, const S& settings) {
    json.update(partJson(fields, settings));
    if (!json.contains("plate")) json["plate"] = Json::object();
    return json;
}

// Throws for what is missing, of another kind or out of range.
template <class S>
S partFrom(const Fields<S>& fields, const Json& json) {
    S settings;
    for (const Field& field : fields.rows())
        if (field.restated) (void)json.at(std::string(field.key));
    auto read = readFieldsJson(fields.of(settings), json);
    if (read) read = checkRanges(fields.of(settings));
    if (!read) throw std::invalid_argument(read.error().what);
    return settings;
}

// An absent list is empty.
template <class S>
std::vector<S> listFrom(const Json& json, const char* member, const Fields<S>& fields) {
    std::vector<S> list;
    if (!json.contains(member)) return list;
    if (json.at(member).size() > maxEntries) throw std::invalid_argument("too many entries");
    for (const Json& one : json.at(member)) list.push_back(partFrom(fields, one));
    return list;
}

MassingSettings parseSettings(const Json& json) {
    (void)json.at("plate");
    MassingSettings settings = partFrom(massingFields(), json);
    if (json.contains("podium")) {
        (void)json.at("podium").at("plate");
        settings.podium = partFrom(podiumFields(), json.at("podium"));
    }
    settings.setbacks = listFrom(json, "setbacks", setbackFields());
    settings.uses = listFrom(json, "uses", floorUseFields());
    settings.further = listFrom(json, "further", furtherTowerFields());
    return settings;
}

}  // namespace

Json toJson(const TowerDesign& design) {
    const MassingSettings& settings = design.settings;
    Json json{
        {"lot", design.lotName}, {"lot_outer", ringJson(design.lot.outer)}, {"lot_holes", Json::array()}};
    for (const Ring& hole : design.lot.holes) json["lot_holes"].push_back(ringJson(hole));
    json = withPlate(std::move(json), massingFields(), settings);
    if (settings.podium) json["podium"] = withPlate(Json::object(), podiumFields(), *settings.podium);
    for (const Setback& setback : settings.setbacks)
        json["setbacks"].push_back(partJson(setbackFields(), setback));
    for (const FloorUse& use : settings.uses) json["uses"].push_back(partJson(floorUseFields(), use));
    for (const FurtherTower& tower : settings.further)
        json["further"].push_back(partJson(furtherTowerFields(), tower));
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
