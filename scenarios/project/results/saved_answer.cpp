#include "scenarios/project/results/saved_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/json_number.h"
#include "core/describe/figure_text.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/shadow_figures.h"
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

}  // namespace

std::string layerEnding(TreeColumns column) { return fmt::format(", {}", describeTrees(column)); }

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
                                                {"by-place", parseSunByPlace}};
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

}  // namespace noonmark
