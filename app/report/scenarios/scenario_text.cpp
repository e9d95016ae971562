#include "app/report/scenarios/scenario_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/csv_field.h"
#include "core/measures/has_runs.h"
#include "core/study/provenance/provenance_json.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Json figuresJson(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    const ShadowStatistics& figures = scenario.study->statistics;
    const bool runs = hasRuns(figures);
    return {{"receivers", figures.receivers},
            {"receiver_area_m2", figures.receiverAreaM2},
            {"shadow_area_m2", figures.shadowAreaM2},
            {"shadow_area_change_m2", computeShadowAreaChange(scenarios, scenario)},
            {"mean_gross_min", figures.meanGrossMin},
            {"max_gross_min", figures.maxGrossMin},
            {"mean_continuous_min", runs ? Json(figures.meanContinuousMin) : Json()},
            {"max_continuous_min", runs ? Json(figures.maxContinuousMin) : Json()}};
}

Json impactJson(const std::optional<ScenarioImpact>& impact) {
    if (!impact) return {};
    const ImpactFigures& figures = impact->figures;
    return {{"baseline", impact->baseline},
            {"shadow_area_change_m2", figures.shadowAreaChangeM2},
            {"threshold_min", figures.thresholdMin},
            {"gained_m2", figures.gross.gainedM2},
            {"lost_m2", figures.gross.lostM2}};
}

Json scoreJson(const std::optional<ScenarioScore>& score) {
    if (!score) return {};
    return {{"weights", score->weights},
            {"weighted_shade_m2h", score->weightedShadeM2h},
            {"score_m2", score->scoreM2}};
}

Json verdictsJson(const std::optional<ScenarioVerdicts>& verdicts) {
    if (!verdicts) return {};
    const VerdictCounts& counts = verdicts->counts;
    return {{"rule", verdicts->rule}, {"baseline", verdicts->baseline},
            {"pass", counts.pass},    {"borderline", counts.borderline},
            {"fail", counts.fail},    {"not_judged", counts.notJudged()}};
}

template <class T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

Json usesJson(const ScenarioUses& uses) {
    Json json = Json::array();
    for (const UseArea& area : uses.areas)
        json.push_back({{"use", area.use.empty() ? Json() : Json(area.use)},
                        {"storeys", area.storeys},
                        {"gross_floor_m2", area.grossFloorM2}});
    return json;
}

std::string runsText(const ShadowStatistics& figures) {
    if (!hasRuns(figures)) return ",";
    return fmt::format("{:.3f},{:.3f}", figures.meanContinuousMin, figures.maxContinuousMin);
}

std::string orEmpty(const std::optional<double>& value) {
    return value ? fmt::format("{:.1f}", *value) : std::string();
}

std::string impactFields(const std::optional<ScenarioImpact>& impact) {
    if (!impact) return ",,,,";
    const ImpactFigures& figures = impact->figures;
    return fmt::format("{},{:.1f},{:g},{:.1f},{:.1f}", csvField(impact->baseline), figures.shadowAreaChangeM2,
                       figures.thresholdMin, figures.gross.gainedM2, figures.gross.lostM2);
}

std::string scoreFields(const std::optional<ScenarioScore>& score) {
    if (!score) return ",,";
    const double shade = score->weightedShadeM2h;
    return fmt::format("{},{},{:.1f}", csvField(score->weights),
                       std::isnan(shade) ? std::string() : fmt::format("{:.1f}", shade), score->scoreM2);
}

std::string verdictFields(const std::optional<ScenarioVerdicts>& verdicts) {
    if (!verdicts) return ",,,,,";
    const VerdictCounts& counts = verdicts->counts;
    return fmt::format("{},{},{},{},{},{}", csvField(verdicts->rule), csvField(verdicts->baseline),
                       counts.pass, counts.borderline, counts.fail, counts.notJudged());
}

std::string answerFields(const ScenarioStudy& scenario) {
    const ScenarioAnswers& answers = scenario.answers;
    return fmt::format("{},{},{},{},{}", orEmpty(scenario.heightM), orEmpty(sumFloorAreaM2(scenario.uses)),
                       impactFields(answers.impact), scoreFields(answers.score),
                       verdictFields(answers.verdicts));
}

}  // namespace

std::string scenariosCsv(const ScenarioStudies& scenarios) {
    std::string csv =
        "name,changes,receiver_area_m2,shadow_area_m2,shadow_area_change_m2,mean_gross_min,"
        "mean_continuous_min,max_continuous_min,height_m,gross_floor_m2,impact_baseline,impact_m2,"
        "impact_threshold_min,gained_m2,lost_m2,weights,weighted_shade_m2h,score_m2,rule,rule_baseline,pass,"
        "borderline,fail,"
        "not_judged" +
        std::string(sourceColumns) + "\r\n";
    for (const ScenarioStudy& scenario : scenarios) {
        const ShadowStatistics& figures = scenario.study->statistics;
        csv +=
            fmt::format("{},{},{:.1f},{:.1f},{:.1f},{:.3f},{},{}{}\r\n", csvField(scenario.name),
                        countChanges(scenario), figures.receiverAreaM2, figures.shadowAreaM2,
                        computeShadowAreaChange(scenarios, scenario), figures.meanGrossMin, runsText(figures),
                        answerFields(scenario), sourceFields(scenario.study->provenance));
    }
    return csv;
}

std::string scenarioUsesCsv(const ScenarioStudies& scenarios) {
    std::string csv = "scenario,use,storeys,gross_floor_m2\r\n";
    for (const ScenarioStudy& scenario : scenarios)
        for (const UseArea& area : scenario.uses.areas)
            csv += fmt::format("{},{},{},{:.1f}\r\n", csvField(scenario.name), csvField(area.use),
                               area.storeys, area.grossFloorM2);
    return csv;
}

std::string scenariosJson(const ScenarioStudies& scenarios) {
    Json json = settingsJson(scenarios.front().study->settings);
    json["compared_with"] = scenarios.front().name;
    json["scenarios"] = Json::array();
    for (const ScenarioStudy& scenario : scenarios) {
        Json one{{"name", scenario.name},
                 {"changes", countChanges(scenario)},
                 {"engine", scenario.study->field.engine},
                 {"figures", figuresJson(scenarios, scenario)},
                 {"floor_area_by_use", usesJson(scenario.uses)},
                 {"towers_not_counted_by_use", scenario.uses.towersNotCounted},
                 {"gross_floor_m2", orNull(sumFloorAreaM2(scenario.uses))},
                 {"height_m", orNull(scenario.heightM)},
                 {"impact", impactJson(scenario.answers.impact)},
                 {"score", scoreJson(scenario.answers.score)},
                 {"verdicts", verdictsJson(scenario.answers.verdicts)}};
        addProvenance(one, scenario.study->provenance);
        one["warnings"] = warningsJson(scenario.study->warnings);
        json["scenarios"].push_back(std::move(one));
    }
    json["definitions"] = {
        {"shadow_area_m2", "sum over receivers of (share of the sunlit time in shadow x cell area)"},
        {"shadow_area_change_m2", "shadow area minus that of the scenario named by compared_with"},
        {"floor_area_by_use",
         "storeys and gross floor area of the scenario's towers by use; use null: none is stated. Imported "
         "buildings and towers whose height was changed afterwards are counted in towers_not_counted_by_use"},
        {"height_m", "greatest height above its ground of the buildings that the scenario adds"},
        {"impact",
         "change from the scenario baseline, on the receivers of both; gained_m2: area whose gross "
         "shadow rises by more than threshold_min"},
        {"weighted_shade_m2h", weightedShadeDefinition},
        {"score_m2", scoreDefinition},
        {"verdicts",
         "places or windows with each verdict of the rule; not_judged: it does not apply to them, "
         "or was not checked"},
        {"gross", "minutes in shadow per day, mean over the days"},
        {"continuous", "longest unbroken run in shadow on any day, minutes"}};
    return toJsonText(json);
}

}  // namespace noonmark
