#include "app/report/scenarios/scenario_text.h"

#include <algorithm>
#include <iterator>

#include "app/report/scenarios/scenario_months.h"
#include "core/describe/figure_text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/provenance_json.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Json measuredJson(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    Json json = figuresJson(shadowFigures().of(scenario.study->statistics));
    json["shadow_area_change_m2"] = computeShadowAreaChange(scenarios, scenario);
    return json;
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
    Json json{{"weights", score->weights}};
    json.update(figuresJson(scoreFigures().of(score->totals)));
    json["errors"] = errorsJson(score->errors);
    return json;
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

std::vector<Figure> listCompared() {
    const auto all = shadowFigures().rows();
    std::vector<Figure> compared;
    std::ranges::copy_if(all, std::back_inserter(compared), &Figure::inTable);
    return compared;
}

// The change of the shadow area stands behind the shadow area.
std::vector<std::string> columnsOfMeasured() {
    std::vector<std::string> columns = listColumns(listCompared());
    columns.insert(std::ranges::find(columns, "shadow_area_m2") + 1, "shadow_area_change_m2");
    return columns;
}

void addMeasured(CsvText& csv, const ShadowStatistics& statistics, double changeM2) {
    for (const Figure& figure : listCompared()) {
        addFigures(csv, {{&figure, 1}, &statistics});
        if (figure.key == "shadow_area_m2") csv.number(changeM2, 1);
    }
}

void addImpact(CsvText& csv, const std::optional<ScenarioImpact>& impact) {
    if (!impact) return void(csv.nothing(5));
    const ImpactFigures& figures = impact->figures;
    csv.text(impact->baseline).number(figures.shadowAreaChangeM2, 1).number(figures.thresholdMin);
    csv.number(figures.gross.gainedM2, 1).number(figures.gross.lostM2, 1);
}

void addScore(CsvText& csv, const std::optional<ScenarioScore>& score) {
    if (!score) return void(csv.nothing(3));
    csv.text(score->weights);
    addFigures(csv, scoreFigures().of(score->totals));
}

void addVerdicts(CsvText& csv, const std::optional<ScenarioVerdicts>& verdicts) {
    if (!verdicts) return void(csv.nothing(6));
    const VerdictCounts& counts = verdicts->counts;
    csv.text(verdicts->rule).text(verdicts->baseline);
    csv.whole(counts.pass).whole(counts.borderline).whole(counts.fail).whole(counts.notJudged());
}

}  // namespace

std::string scenariosCsv(const ScenarioStudies& scenarios) {
    std::vector<std::string> columns{"name", "changes"};
    std::ranges::move(columnsOfMeasured(), std::back_inserter(columns));
    columns.insert(columns.end(),
                   {"height_m", "gross_floor_m2", "impact_baseline", "impact_m2", "impact_threshold_min",
                    "gained_m2", "lost_m2", "weights", "weighted_shade_m2h", "score_m2", "rule",
                    "rule_baseline", "pass", "borderline", "fail", "not_judged"});
    CsvText csv(withSourceColumns(std::move(columns)));
    for (const ScenarioStudy& scenario : scenarios) {
        const ScenarioAnswers& answers = scenario.answers;
        csv.text(scenario.name).whole(countChanges(scenario));
        addMeasured(csv, scenario.study->statistics, computeShadowAreaChange(scenarios, scenario));
        csv.number(scenario.heightM, 1).number(sumFloorAreaM2(scenario.uses), 1);
        addImpact(csv, answers.impact);
        addScore(csv, answers.score);
        addVerdicts(csv, answers.verdicts);
        addSource(csv, sourceValues(scenario.study->provenance));
        csv.endRow();
    }
    return csv.take();
}

std::string scenarioUsesCsv(const ScenarioStudies& scenarios) {
    CsvText csv({"scenario", "use", "storeys", "gross_floor_m2"});
    for (const ScenarioStudy& scenario : scenarios)
        for (const UseArea& area : scenario.uses.areas)
            csv.text(scenario.name).text(area.use).whole(area.storeys).number(area.grossFloorM2, 1).endRow();
    return csv.take();
}

std::string scenariosJson(const ScenarioStudies& scenarios, const FailedScenarios& failed) {
    Json json = settingsJson(scenarios.front().study->settings);
    json["compared_with"] = scenarios.front().name;
    json["scenarios"] = Json::array();
    const std::vector<MonthChart> months = makeMonthCharts(listMonths(scenarios));
    for (const ScenarioStudy& scenario : scenarios) {
        Json one{{"name", scenario.name},
                 {"changes", countChanges(scenario)},
                 {"engine", scenario.study->field.engine},
                 {"figures", measuredJson(scenarios, scenario)},
                 {"floor_area_by_use", usesJson(scenario.uses)},
                 {"towers_not_counted_by_use", scenario.uses.towersNotCounted},
                 {"gross_floor_m2", orNull(sumFloorAreaM2(scenario.uses))},
                 {"height_m", orNull(scenario.heightM)},
                 {"impact", impactJson(scenario.answers.impact)},
                 {"score", scoreJson(scenario.answers.score)},
                 {"verdicts", verdictsJson(scenario.answers.verdicts)},
                 {"months", monthsJson(months, scenario.name)}};
        addProvenance(one, scenario.study->provenance);
        one["warnings"] = warningsJson(scenario.study->warnings);
        json["scenarios"].push_back(std::move(one));
    }
    json["failed"] = Json::array();
    for (const FailedScenario& one : failed)
        json["failed"].push_back({{"name", one.name}, {"error", one.error.text()}});
    json["definitions"] = definitionsJson(shadowFigures().rows());
    json["definitions"].update(definitionsJson(scoreFigures().rows()));
    json["definitions"].update(definitionsJson(months));
    json["definitions"].update(
        {{"shadow_area_change_m2", "shadow area minus that of the scenario named by compared_with"},
         {"floor_area_by_use",
          "storeys and gross floor area of the scenario's towers by use; use null: none is stated. Imported "
          "buildings and towers whose height was changed afterwards are counted in "
          "towers_not_counted_by_use"},
         {"height_m", "greatest height above its ground of the buildings that the scenario adds"},
         {"impact",
          "change from the scenario baseline, on the receivers of both; gained_m2: area whose gross "
          "shadow rises by more than threshold_min"},
         {"verdicts",
          "places or windows with each verdict of the rule; not_judged: it does not apply to them, "
          "or was not checked"},
         {"months",
          "figures of each month, as far as they were computed, and their changes from the scenario named by "
          "compared_with"},
         {"gross", "minutes in shadow per day, mean over the days"},
         {"continuous", "longest unbroken run in shadow on any day, minutes"}});
    return toJsonText(json);
}

}  // namespace noonmark
