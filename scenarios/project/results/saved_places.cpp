#include <algorithm>
#include <utility>

#include "core/base/json_number.h"
#include "core/describe/field_json.h"
#include "core/describe/figure_text.h"
#include "core/engines/api/tree_shade.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sum_places.h"
#include "core/study/by_place/sun_by_place.h"
#include "scenarios/project/results/saved_answer.h"
#include "scenarios/project/results/saved_figures_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Ring ringOf(const Json& json) {
    Ring ring;
    for (const Json& corner : json) ring.emplace_back(corner.at(0).get<float>(), corner.at(1).get<float>());
    if (ring.size() < 3) throw std::invalid_argument("an outline has too few corners");
    return ring;
}

std::vector<Footprint> outlineOf(const Json& json) {
    std::vector<Footprint> polygons;
    for (const Json& rings : json) {
        Footprint polygon{ringOf(rings.at(0)), {}};
        for (std::size_t hole = 1; hole < rings.size(); ++hole) polygon.holes.push_back(ringOf(rings[hole]));
        polygons.push_back(std::move(polygon));
    }
    if (polygons.empty()) throw std::invalid_argument("a place has no outline");
    return polygons;
}

}  // namespace

Place parseSavedPlace(const Json& json, const Json& outline) {
    const auto kind = parsePlaceKind(json.at("kind").get<std::string>());
    if (!kind) throw std::invalid_argument("the kind of a place is unknown");
    return {json.at("name"), *kind, outlineOf(outline), json.at("source")};
}

namespace {

std::vector<double> listNumbers(const Json& json, const std::string& member) {
    std::vector<double> numbers;
    for (const Json& value : json.value(member, Json::object()))
        numbers.push_back(value.is_null() ? SunOfPlace::none : value.get<double>());
    return numbers;
}

// Hours by month and by date of a place, which are no figures of the table. `suffix`: of columns with trees.
void readParts(const Json& json, const std::string& suffix, SunOfPlace& sun) {
    sun.monthHours = listNumbers(json, "month_hours" + suffix);
    sun.dateHours = listNumbers(json, "date_hours" + suffix);
    sun.belowShare = listNumbers(json, "share_below" + suffix);
    sun.seasonHours = listNumbers(json, "season_hours" + suffix);
}

template <class R>
R readRows(std::span<const Figure> rows, const Json& json) {
    R read;
    readRows(rows, json, read);
    return read;
}

// The area and the cells are those of the sun without trees.
SunOfPlace sunWithTrees(const Json& json, TreeColumns column, const SunOfPlace& without) {
    auto sun = readRows<SunOfPlace>(sunFiguresWithTrees(column), json);
    readParts(json, suffixOf(column), sun);
    sun.areaM2 = without.areaM2;
    sun.cellM = without.cellM;
    return sun;
}

SunOfPlace sunOfPlace(const Json& json) {
    SunOfPlace sun = readFigures(sunOfPlaceFigures(), json);
    readParts(json, {}, sun);
    const Json cell = json.value("cell_m", Json());
    if (cell.is_number()) sun.cellM = cell;
    const std::string why = json.value("without_figures", std::string());
    sun.status = findChoice(placeStatusChoices(), why).value_or(PlaceStatus::measured);
    for (const Json& remark : json.value("remarks", Json::array()))
        if (const auto known = findChoice(placeRemarkChoices(), remark.get<std::string>()))
            sun.remarks.push_back(*known);
    return sun;
}

// The days alone: how many steps each has. Answers of earlier versions lack them.
SunSteps daylightOf(const Json& json) {
    SunSteps sun;
    if (!json.is_object()) return sun;
    sun.stepMinutes = json.at("step_min");
    for (const Json& day : json.at("days"))
        if (const auto date = parseDate(day.at(0).get<std::string>()))
            sun.days.push_back({.date = *date, .count = day.at(1)});
    return sun;
}

// The figures of each place have them.
std::vector<CivilDate> datesOf(const Json& place) {
    std::vector<CivilDate> dates;
    const Json shares = place.value("share_below", Json::object());
    for (const auto& share : shares.items())
        if (const auto day = parseDate(share.key())) dates.push_back(*day);
    return dates;
}

// Those that a place's figures have in one city, without their sun.
std::vector<SunWithTrees> treeColumnsOf(const Json& figures) {
    std::vector<SunWithTrees> columns;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (figures.contains(sunFiguresWithTrees(column).front().key)) columns.push_back({column, {}});
    return columns;
}

// What the figures of all cities have in common: their settings, places and dates.
SunByPlace sunWithoutFigures(const Json& json) {
    SunByPlace sun;
    if (auto read = readFieldsJson(sunByPlaceFields().of(sun.settings), json); !read)
        throw std::invalid_argument(read.error().text());
    sun.settings.study.receivers.cellM = json.at("cell_m");
    sun.possibleHours = json.at("possible_hours");
    const Json& places = json.at("places");
    const Json& outlines = json.at("kept").at("places");
    for (std::size_t i = 0; i < places.size(); ++i)
        sun.places.push_back(parseSavedPlace(places[i], outlines.at(i)));
    sun.partOf = findWholes(sun.places);
    sun.daylight = daylightOf(json.at("kept").value("daylight", Json()));
    const Json seasons = json.value("seasons", Json::object());
    for (const auto& season : seasons.items()) sun.seasons.push_back({season.key(), season.value()});
    if (places.empty()) return sun;
    sun.withTrees = treeColumnsOf(places[0]);
    sun.treesHow = json.value("engine_trees", std::string());
    const Json months = places[0].value("month_hours", Json::object());
    for (const auto& month : months.items()) sun.months.push_back(month.key());
    sun.settings.dates = datesOf(places[0]);
    return sun;
}

// An error that was measured needs no reason why it was not.
std::string placeErrorOf(const Json& error) {
    if (!error.is_object()) return {};
    Json study{{"error", error}};
    study["error"]["why_not"] = nullptr;
    return parseErrorText(study);
}

// The compared cities by the names that they had, without figures.
std::vector<ComparedSun> citiesOf(const Json& json, const SunByPlace& baseline) {
    std::vector<ComparedSun> cities;
    for (const Json& scenario : json.at("scenarios")) {
        cities.push_back({baseline, {}});
        cities.back().sun.name = scenario.at("name");
        cities.back().sun.errors = savedErrors(scenario);
        if (const Json& places = json.at("places"); !places.empty())
            cities.back().sun.withTrees = treeColumnsOf(places[0].at("scenarios").at(scenario.at("name")));
    }
    return cities;
}

void addWithTrees(const Json& json, SunByPlace& sun) {
    for (SunWithTrees& with : sun.withTrees)
        with.sun.push_back(sunWithTrees(json, with.column, sun.sun.back()));
}

void addChangesWithTrees(const Json& json, ComparedSun& compared) {
    compared.changesWithTrees.resize(compared.sun.withTrees.size());
    for (std::size_t i = 0; i < compared.sun.withTrees.size(); ++i)
        compared.changesWithTrees[i].push_back(
            readRows<SunChange>(changeFiguresWithTrees(compared.sun.withTrees[i].column), json));
}

}  // namespace

SavedSunByPlace parseSunByPlace(const SavedResult& result, const Json& json) {
    SavedSunByPlace saved{.sun = {.baseline = sunWithoutFigures(json), .compared = {}}};
    SunOfCities& sun = saved.sun;
    sun.baseline.name = result.baseline.empty() ? result.scenario : result.baseline;
    sun.baseline.errors = savedErrors(json);
    if (!result.baseline.empty()) sun.compared = citiesOf(json, sun.baseline);
    for (const Json& place : json.at("places")) {
        sun.baseline.sun.push_back(sunOfPlace(place));
        addWithTrees(place, sun.baseline);
        for (ComparedSun& compared : sun.compared) {
            const Json& other = place.at("scenarios").at(compared.sun.name);
            compared.sun.sun.push_back(sunOfPlace(other));
            addWithTrees(other, compared.sun);
            compared.changes.push_back(readFigures(sunChangeFigures(), other));
            addChangesWithTrees(other, compared);
        }
    }
    if (!sun.compared.empty()) sun.compared.back().sun.name = result.scenario;  // it may have been renamed
    saved.steps = wholeNumberFrom<std::uint64_t>(json.at("steps"));
    saved.belowHorizon = wholeNumberFrom<std::uint64_t>(json.at("steps_below_horizon"));
    saved.seconds = json.at("seconds").value("total", 0.0);
    saved.error = placeErrorOf(json.at("error"));
    return saved;
}

}  // namespace noonmark
