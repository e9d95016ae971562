#include "scenarios/project/results/saved_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "core/base/json_number.h"
#include "core/describe/field_json.h"
#include "core/describe/figure_text.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/by_place/sum_places.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/results/saved_figures_json.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

const std::vector<float>& layerOf(const SavedResult& result, std::size_t number) {
    if (number >= result.layers.size()) throw std::invalid_argument("a layer is missing");
    const std::vector<float>& values = result.layers[number].values;
    if (values.size() != result.grid.size()) throw std::invalid_argument("a layer has another size");
    return values;
}

// The layer of continuous shadow; it is not stored where it was not computed.
std::vector<float> takeRuns(const SavedResult& result, std::size_t number, bool counted) {
    if (counted) return layerOf(result, number);
    return std::vector<float>(result.grid.size(), std::numeric_limits<float>::quiet_NaN());
}

std::optional<TimeWeights> weightsOf(const Json& json, const Json& saved) {
    if (!saved.contains("weights")) return std::nullopt;
    const auto table = parseWeightsJson(saved.at("weights").dump(), json.at("weights"));
    if (!table) throw std::invalid_argument(table.error().what);
    return *table;
}

// A text that not every question states.
std::string textOf(const Json& json, const char* member) {
    const Json text = json.value(member, Json());
    return text.is_string() ? text.get<std::string>() : std::string();
}

SavedOrigin originOf(const Json& json) {
    const Json saved = json.value("kept", Json::object());
    const Json region = json.value("region", Json());
    return {saved.value("at", ""),
            saved.value("city_sha256", ""),
            saved.value("baseline_sha256", ""),
            saved.value("others_sha256", std::map<std::string, std::string>()),
            saved.value("question_sha256", ""),
            textOf(json, "program"),
            textOf(json, json.contains("engine_settings") ? "engine_settings" : "engine_used"),
            readStatedPeriod(json.value("period", Json::object())),
            region.is_object() ? textOf(region, "name") : textOf(json, "region"),
            weightsOf(json, saved),
            textOf(json, "rule_name")};
}

// Older results store only the requested step length, which was used as it was.
double countedStepOf(const Json& json) {
    const Json& period = json.at("period");
    return period.value("counted_step_min", period.at("step_min").get<double>());
}

std::vector<Contribution> contributionsOf(const Json& json) {
    std::vector<Contribution> contributions;
    for (const Json& one : json) {
        contributions.push_back(readFigures(contributionFigures(), one));
        contributions.back().id = one.at("source_id");
        contributions.back().name = one.at("name");
    }
    return contributions;
}

const SavedLayer* findLayer(const SavedResult& result, const std::string& name) {
    const auto found = std::ranges::find(result.layers, name, &SavedLayer::name);
    return found == result.layers.end() ? nullptr : &*found;
}

// The field of one column of trees; none where it was not measured, or its map not stored.
std::optional<ShadowField> fieldWithTrees(const SavedResult& result, const ShadowField& without,
                                          TreeColumns column) {
    const SavedLayer* gross = findLayer(result, grossLayer + layerEnding(column));
    if (!gross) return std::nullopt;
    ShadowField field = without;
    field.trees = nullptr;
    const SavedLayer* runs = findLayer(result, runLayer + layerEnding(column));
    field.grossMin = layerOf(result, std::size_t(gross - result.layers.data()));
    field.continuousMin = takeRuns(result, runs ? std::size_t(runs - result.layers.data()) : 0, runs);
    return field;
}

void readTrees(const SavedResult& result, ShadowField& field) {
    TreeShade shade;
    shade.evergreen = fieldWithTrees(result, field, TreeColumns::evergreen);
    shade.seasonal = fieldWithTrees(result, field, TreeColumns::seasonal);
    if (!shade.evergreen && !shade.seasonal) return;
    field.trees = std::make_shared<const TreeShade>(std::move(shade));
}

SavedStudy studyOf(const SavedResult& result, const Json& json) {
    SavedStudy study;
    ShadowField& field = study.field;
    field.grid = result.grid;
    field.grossMin = layerOf(result, 0);
    study.statistics = parseStatistics(json);
    field.continuousMin = takeRuns(result, 1, hasRuns(study.statistics));
    field.sunlitMinutesPerDay = json.at("sunlit_min_per_day");
    field.stepMinutes = countedStepOf(json);
    field.days = wholeNumberFrom<int>(json.at("period").at("days"));
    field.engine = json.at("engine_settings");
    readTrees(result, field);
    study.steps = wholeNumberFrom<std::uint64_t>(json.at("steps"));
    study.belowHorizon = wholeNumberFrom<std::uint64_t>(json.at("steps_below_horizon"));
    study.seconds = json.at("seconds").value("accumulate", 0.0);
    study.error = parseErrorText(json);
    study.errors = savedErrors(json);
    study.start = parseDate(json.at("period").at("start").get<std::string>()).value_or(CivilDate());
    study.months = parseMonths(json.value("by_month", Json::array()));
    const Json saved = json.value("kept", Json::object());
    if (saved.contains("contributions")) study.contributions = contributionsOf(saved.at("contributions"));
    if (saved.contains("tree_contributions"))
        study.trees = parseTreeContributions(saved.at("tree_contributions"));
    return study;
}

std::optional<SavedImpact::Sides> sidesOf(const SavedResult& result, const Impact& impact) {
    const auto fieldOf = [&](const std::string& name) {
        ShadowField field;
        field.grid = impact.grid;
        if (const SavedLayer* layer = findLayer(result, name)) field.grossMin = layer->values;
        field.sunlitMinutesPerDay = impact.sunlitMinutesPerDay;
        field.stepMinutes = impact.stepMinutes;
        return field;
    };
    SavedImpact::Sides sides{fieldOf(beforeLayer), fieldOf(afterLayer)};
    const auto isWhole = [&](const ShadowField& field) {
        return field.grossMin.size() == impact.grid.size();
    };
    return isWhole(sides.before) && isWhole(sides.after) ? std::optional(std::move(sides)) : std::nullopt;
}

SavedImpact impactOf(const SavedResult& result, const Json& json) {
    SavedImpact saved{{}, parseComparison(json)};
    Impact& impact = saved.impact;
    impact.grid = result.grid;
    impact.grossMin = layerOf(result, 0);
    impact.continuousMin = takeRuns(result, 1, hasRuns(saved.figures.all.front()));
    impact.change = parseChangedCells(
        json.value("kept", Json::object()).value("changed_cells", Json::array()), result.grid.size());
    impact.sunlitMinutesPerDay = json.at("sunlit_min_per_day");
    impact.stepMinutes = countedStepOf(json);
    impact.engine = saved.figures.engine;
    saved.sides = sidesOf(result, impact);
    return saved;
}

SavedScore readScore(const SavedResult& result, const Json& json) {
    SavedScore saved{parseScore(json), json.at("weights")};
    saved.score.grid = result.grid;
    saved.score.score = layerOf(result, 0);
    return saved;
}

// Earlier results have no 99th percentile, and no error of the longest sun.
QuantityError quantityErrorOf(const Json& json) {
    constexpr double notMeasured =
        std::numeric_limits<double>::quiet_NaN();  // in results of earlier versions
    return {json.at("mean_pct"), json.value("p99_pct", notMeasured), json.at("max_pct")};
}

std::string elementErrorOf(const Json& json) {
    const Json error = json.value("error", Json());
    if (!error.is_object()) return {};
    ElementError read{.points = wholeNumberFrom<std::size_t>(error.at("points")),
                      .gross = quantityErrorOf(error.at("gross")),
                      .continuous = quantityErrorOf(error.at("continuous"))};
    const Json sun = error.value("longest_sun", Json());
    if (sun.is_object()) read.longestSun = quantityErrorOf(sun);
    return describe(read);
}

SourceValues sourceOf(const Json& json) {
    SourceValues source;
    const Json saved = json.value("kept", Json::object()).value("source", Json::array());
    for (std::size_t i = 0; i < std::min(saved.size(), source.size()); ++i) source[i] = saved.at(i);
    return source;
}

SavedElements elementsOf(const SavedResult& result, const Json& json) {
    if (result.elements.empty()) throw std::invalid_argument("its points are missing");
    SavedElements saved;
    saved.map = {result.elements, json.at("sunlit_min_per_day")};
    saved.figures = readFigures(elementFigures(), json);
    saved.steps = wholeNumberFrom<std::uint64_t>(json.at("steps"));
    saved.belowHorizon = wholeNumberFrom<std::uint64_t>(json.at("steps_below_horizon"));
    saved.seconds = json.at("seconds").value("accumulate", 0.0);
    saved.byRays = json.at("engine_used") == std::string(referenceEngine);
    saved.error = elementErrorOf(json);
    saved.source = sourceOf(json);
    return saved;
}

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

Place placeOf(const Json& json, const Json& outline) {
    const auto kind = parsePlaceKind(json.at("kind").get<std::string>());
    if (!kind) throw std::invalid_argument("the kind of a place is unknown");
    return {json.at("name"), *kind, outlineOf(outline), json.at("source")};
}

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
    for (std::size_t i = 0; i < places.size(); ++i) sun.places.push_back(placeOf(places[i], outlines.at(i)));
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

SavedSunByPlace sunByPlaceOf(const SavedResult& result, const Json& json) {
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

/// hashCity() of the scenarios of a project, each computed once.
class CityHashes {
public:
    explicit CityHashes(const Project& project) : project_(project) {}
    /// None: there is no such scenario.
    const std::optional<std::string>& of(const std::string& scenario) {
        const auto [at, isNew] = hashes_.try_emplace(scenario);
        if (!isNew) return at->second;
        if (const auto city = cityOf(project_, scenario)) at->second = hashCity(city->city);
        return at->second;
    }

private:
    const Project& project_;
    std::map<std::string, std::optional<std::string>> hashes_;
};

void compareCity(std::vector<std::string>& changes, const std::string& scenario, const std::string& hash,
                 CityHashes& hashes) {
    const auto& now = hashes.of(scenario);
    if (!now)
        changes.push_back(fmt::format("The scenario '{}' no longer exists.", scenario));
    else if (!hash.empty() && *now != hash)
        changes.push_back(
            fmt::format("'{}' has changed since: its buildings, its terrain or its water.", scenario));
}

constexpr std::size_t maxPlacesNamed = 3;

// Whatever its pieces: a file that is read again may have them in another order.
bool haveSameOutline(const Place& one, const Place& other) {
    constexpr float nearM = 0.05F;
    constexpr double share = 0.001;
    const Box2 box = bounds(one), second = bounds(other);
    return glm::distance(box.low, second.low) < nearM && glm::distance(box.high, second.high) < nearM &&
           std::abs(area(one) - area(other)) < share * (1 + area(one));
}

// Of other kinds, and of damaged results, which are refused elsewhere: none.
std::vector<Place> placesOf(const SavedResult& result) try {
    std::vector<Place> places;
    if (result.kind != "by-place") return places;
    const Json json = Json::parse(result.settings);
    const Json &listed = json.at("places"), &outlines = json.at("kept").at("places");
    for (std::size_t i = 0; i < listed.size(); ++i) places.push_back(placeOf(listed[i], outlines.at(i)));
    return places;
} catch (const std::exception&) {
    return {};
}

std::vector<std::string> listChanges(const SavedResult& result, const SavedOrigin& origin,
                                     const Project& project, CityHashes& hashes) {
    std::vector<std::string> changes;
    compareCity(changes, result.scenario, origin.citySha256, hashes);
    if (!result.baseline.empty()) compareCity(changes, result.baseline, origin.baselineSha256, hashes);
    for (const auto& [scenario, hash] : origin.othersSha256) compareCity(changes, scenario, hash, hashes);
    std::ranges::move(findChangedPlaces(placesOf(result), project), std::back_inserter(changes));
    if (result.inputs != inputsJson(project.inputs).dump())
        changes.emplace_back("The city has been read from other files since.");
    if (origin.citySha256.empty())
        changes.emplace_back(
            "It is not known whether buildings have changed since: the result was saved without a hash.");
    return changes;
}

}  // namespace

std::string layerEnding(TreeColumns column) { return fmt::format(", {}", describeTrees(column)); }

std::vector<std::string> findChangedPlaces(const std::vector<Place>& measured, const Project& project) {
    std::vector<Place> ofRegions;
    for (const Region& region : project.regions) ofRegions.push_back(makePlace(region));
    std::map<std::string_view, const Place*> now;
    for (const auto* places : {&project.places, &std::as_const(ofRegions)})
        for (const Place& place : *places) now.emplace(place.name, &place);
    std::vector<std::string> changes;
    std::size_t more = 0;
    for (const Place& place : measured) {
        const auto found = now.find(place.name);
        const bool isThere = found != now.end();
        if (isThere && found->second->kind == place.kind && haveSameOutline(place, *found->second)) continue;
        if (changes.size() == maxPlacesNamed) {
            ++more;
            continue;
        }
        changes.push_back(isThere
                              ? fmt::format("The place '{}' has another kind or outline since.", place.name)
                              : fmt::format("The place '{}' is gone, or has another name.", place.name));
    }
    if (more > 0) changes.push_back(fmt::format("{} more places have changed since.", more));
    return changes;
}

Result<SavedOrigin> readSavedOrigin(const SavedResult& result) try {
    return originOf(Json::parse(result.settings));
} catch (const std::exception& problem) {  // JSON of the wrong shape
    return failure(fmt::format("The saved result cannot be read ({})", problem.what()), result.name,
                   "Measure and save it again");
}

std::span<const SavedKind> savedKinds() {
    static const std::array<SavedKind, 5> kinds{SavedKind{"study", studyOf},
                                                {"impact", impactOf},
                                                {"score", readScore},
                                                {"elements", elementsOf},
                                                {"by-place", sunByPlaceOf}};
    return kinds;
}

Result<SavedAnswer> readSavedAnswer(const SavedResult& result, std::span<const SavedKind> kinds) try {
    const Json json = Json::parse(result.settings);
    const auto known = std::ranges::find(kinds, result.kind, &SavedKind::kind);
    if (known == kinds.end())
        return failure(fmt::format("This version cannot show results of the kind '{}'", result.kind),
                       result.name, "Open the project with a newer Noonmark");
    return SavedAnswer{originOf(json), known->read(result, json), parseContributions(json)};
} catch (const std::exception& problem) {  // JSON or layers of the wrong shape
    return failure(fmt::format("The saved result cannot be shown ({})", problem.what()), result.name,
                   "Measure and save it again");
}

std::vector<std::string> findChangesSince(const SavedResult& result, const SavedOrigin& origin,
                                          const Project& project) {
    CityHashes hashes(project);
    return listChanges(result, origin, project, hashes);
}

Result<std::set<std::string>> findOutdated(const std::vector<std::shared_ptr<const SavedResult>>& results,
                                           const Project& project, const std::stop_token& stop) {
    CityHashes hashes(project);
    std::set<std::string> outdated;
    for (const auto& result : results) {
        if (stop.stop_requested()) return cancelled();
        const auto origin = readSavedOrigin(*result);
        if (!origin || !listChanges(*result, *origin, project, hashes).empty()) outdated.insert(result->name);
    }
    return outdated;
}

// The name does not matter: a table with equal intervals counts as unchanged.
std::vector<std::string> findWeightChangesSince(const SavedOrigin& origin, const Project& project) {
    if (!origin.weights) return {};
    const TimeWeights& then = *origin.weights;
    if (const auto now = findWeights(project, then.name)) {
        if (*now == then) return {};
        return {fmt::format("The weight table '{}' has changed since.", then.name)};
    }
    if (std::ranges::find(project.weights, then.intervals, &TimeWeights::intervals) != project.weights.end())
        return {};
    return {fmt::format("The weight table '{}' no longer exists.", then.name)};
}

}  // namespace noonmark
