#include "scenarios/project/kept_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/json_number.h"
#include "core/study/inputs_json.h"
#include "core/study/study_hash.h"
#include "scenarios/impact/impact_runs.h"
#include "scenarios/project/changed_cells_json.h"
#include "scenarios/project/kept_figures_json.h"
#include "scenarios/weights/weights_text.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

const std::vector<float>& layerOf(const KeptResult& result, std::size_t number) {
    if (number >= result.layers.size()) throw std::invalid_argument("a layer is missing");
    const std::vector<float>& values = result.layers[number].values;
    if (values.size() != result.grid.size()) throw std::invalid_argument("a layer has another size");
    return values;
}

// Of a map of runs, which are not kept where they were not counted.
std::vector<float> runsOf(const KeptResult& result, std::size_t number, bool counted) {
    if (counted) return layerOf(result, number);
    return std::vector<float>(result.grid.size(), std::numeric_limits<float>::quiet_NaN());
}

std::optional<TimeWeights> weightsOf(const Json& json, const Json& kept) {
    if (!kept.contains("weights")) return std::nullopt;
    const auto table = weightsFromJson(kept.at("weights").dump(), json.at("weights"));
    if (!table) throw std::invalid_argument(table.error().what);
    return *table;
}

KeptOrigin originOf(const Json& json) {
    const Json kept = json.value("kept", Json::object());
    const Json& region = json.at("region");
    return {kept.value("at", ""),
            kept.value("city_sha256", ""),
            kept.value("baseline_sha256", ""),
            json.at("program"),
            json.at("engine_settings"),
            json.at("period").at("text"),
            region.is_object() ? region.at("name").get<std::string>() : region.get<std::string>(),
            weightsOf(json, kept)};
}

// Results of before had steps of just the length that was asked for.
double countedStepOf(const Json& json) {
    const Json& period = json.at("period");
    return period.value("counted_step_min", period.at("step_min").get<double>());
}

KeptStudy studyOf(const KeptResult& result, const Json& json) {
    KeptStudy study;
    ShadowField& field = study.field;
    field.grid = result.grid;
    field.grossMin = layerOf(result, 0);
    study.statistics = statisticsFrom(json);
    field.continuousMin = runsOf(result, 1, hasRuns(study.statistics));
    field.sunlitMinutesPerDay = json.at("sunlit_min_per_day");
    field.stepMinutes = countedStepOf(json);
    field.days = wholeNumberFrom<int>(json.at("period").at("days"));
    field.engine = json.at("engine_settings");
    study.steps = wholeNumberFrom<std::uint64_t>(json.at("steps"));
    study.belowHorizon = wholeNumberFrom<std::uint64_t>(json.at("steps_below_horizon"));
    study.seconds = json.at("seconds").value("accumulate", 0.0);
    study.error = errorWordsFrom(json);
    return study;
}

KeptImpact impactOf(const KeptResult& result, const Json& json) {
    KeptImpact kept{{}, comparisonFrom(json)};
    Impact& impact = kept.impact;
    impact.grid = result.grid;
    impact.grossMin = layerOf(result, 0);
    impact.continuousMin = runsOf(result, 1, hasRuns(kept.figures.all.front()));
    impact.change = changedCellsFrom(json.value("kept", Json::object()).value("changed_cells", Json::array()),
                                     result.grid.size());
    impact.sunlitMinutesPerDay = json.at("sunlit_min_per_day");
    impact.stepMinutes = countedStepOf(json);
    impact.engine = kept.figures.engine;
    return kept;
}

KeptScore scoreOf(const KeptResult& result, const Json& json) {
    KeptScore kept{scoreFrom(json), json.at("weights")};
    kept.score.grid = result.grid;
    kept.score.score = layerOf(result, 0);
    return kept;
}

void compareCity(std::vector<std::string>& changes, const Project& project, const std::string& scenario,
                 const std::string& hash) {
    const auto city = cityOf(project, scenario);
    if (!city)
        changes.push_back(fmt::format("There is no scenario '{}' any more.", scenario));
    else if (!hash.empty() && cityHash(city->city) != hash)
        changes.push_back(fmt::format("'{}' has changed since: its buildings or its terrain.", scenario));
}

}  // namespace

Result<KeptAnswer> answerOf(const KeptResult& result) try {
    const Json json = Json::parse(result.settings);
    const KeptOrigin origin = originOf(json);
    if (result.kind == "study") return KeptAnswer{origin, studyOf(result, json)};
    if (result.kind == "impact") return KeptAnswer{origin, impactOf(result, json)};
    if (result.kind == "score") return KeptAnswer{origin, scoreOf(result, json)};
    return failure(fmt::format("'{}' is no kind of result that this version shows", result.kind), result.name,
                   "Open the project with a newer Noonmark");
} catch (const std::exception& problem) {  // JSON of another shape, layers that do not fit
    return failure(fmt::format("The kept result cannot be shown ({})", problem.what()), result.name,
                   "Measure it again and keep that");
}

std::vector<std::string> changesSince(const KeptResult& result, const KeptOrigin& origin,
                                      const Project& project) {
    std::vector<std::string> changes;
    compareCity(changes, project, result.scenario, origin.citySha256);
    if (!result.baseline.empty()) compareCity(changes, project, result.baseline, origin.baselineSha256);
    if (result.inputs != inputsJson(project.inputs).dump())
        changes.emplace_back("The city was read from other files then.");
    if (origin.citySha256.empty())
        changes.emplace_back(
            "Whether buildings have changed since is not known: it was kept without a hash.");
    return changes;
}

// A table under another name weighs as before.
std::vector<std::string> weightChangesSince(const KeptOrigin& origin, const Project& project) {
    if (!origin.weights) return {};
    const TimeWeights& then = *origin.weights;
    if (const auto now = weightsNamed(project, then.name)) {
        if (*now == then) return {};
        return {fmt::format("The weight table '{}' has changed since.", then.name)};
    }
    if (std::ranges::find(project.weights, then.intervals, &TimeWeights::intervals) != project.weights.end())
        return {};
    return {fmt::format("There is no weight table '{}' any more.", then.name)};
}

}  // namespace noonmark
