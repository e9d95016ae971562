#include "app/report/scenarios/scenario_study.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "app/report/scenarios/scenario_months.h"
#include "core/describe/figure_text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/error_text.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

ScenarioStudy makeScenarioStudy(const std::vector<Scenario>& scenarios, std::string name,
                                std::shared_ptr<const Study> study) {
    const std::vector<Edit> edits = collectEdits(scenarios, name).value_or(std::vector<Edit>());
    const auto heightM = findProposedHeightM(study->city, edits);
    std::vector<ShadedFigures> withTrees;
    for (const ShadeColumn& shade : listShadeColumns(study->field))
        withTrees.push_back({shade.column, computeStatistics(*shade.field)});
    return {std::move(name), std::move(study), sumUses(edits), heightM, {}, std::move(withTrees)};
}

std::size_t countChanges(const ScenarioStudy& scenario) {
    const auto& project = scenario.study->provenance.project;
    return project ? project->scenario.edits.size() : 0;
}

double computeShadowAreaChange(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    return scenario.study->statistics.shadowAreaM2 - scenarios.front().study->statistics.shadowAreaM2;
}

using Json = nlohmann::ordered_json;

namespace {

bool isShaded(const ScenarioStudies& scenarios, TreeColumns column) {
    return std::ranges::any_of(scenarios, [&](const ScenarioStudy& one) {
        return std::ranges::find(one.withTrees, column, &ShadedFigures::column) != one.withTrees.end();
    });
}

Json measuredJson(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    Json json = figuresJson(shadowFigures().of(scenario.study->statistics));
    json["shadow_area_change_m2"] = computeShadowAreaChange(scenarios, scenario);
    for (const ShadedFigures& with : scenario.withTrees)
        json.update(figuresJson({treeFigures(with.column), &with.figures}));
    return json;
}

Json impactJson(const std::optional<ScenarioImpact>& impact) {
    if (!impact) return {};
    Json json{{"baseline", impact->baseline}};
    json.update(figuresJson(impactFigures().of(impact->figures)));
    json.update(figuresJson({figuresByThreshold(), &impact->figures.gross}));
    return json;
}

Json scoreJson(const std::optional<ScenarioScore>& score) {
    if (!score) return {};
    Json json{{"weights", score->weights}};
    json.update(figuresJson(scoreFigures().of(score->totals)));
    for (const ShadedScore& with : score->withTrees)
        json.update(
            figuresJson({scoreFiguresWithTrees(with.column), static_cast<const ScoreTotals*>(&with)}));
    json["errors"] = errorsJson(score->errors);
    return json;
}

double countNotJudged(const VerdictCounts& counts) { return double(counts.notJudged()); }

// Of places or windows.
const Figures<VerdictCounts>& verdictFigures() {
    static const auto figures = [] {
        Figure notJudged = derivedFigure(&countNotJudged, {.key = "not_judged"});
        notJudged.isCount = true;
        return Figures<VerdictCounts>{figure(&VerdictCounts::pass, {.key = "pass"}),
                                      figure(&VerdictCounts::borderline, {.key = "borderline"}),
                                      figure(&VerdictCounts::fail, {.key = "fail"}), std::move(notJudged)};
    }();
    return figures;
}

Json verdictsJson(const std::optional<ScenarioVerdicts>& verdicts) {
    if (!verdicts) return {};
    Json json{{"rule", verdicts->rule}, {"baseline", verdicts->baseline}};
    json.update(figuresJson(verdictFigures().of(verdicts->counts)));
    return json;
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

// A column of scenarios.csv with what it states of a scenario.
struct Column {
    std::string name;
    std::function<void(CsvText&, const ScenarioStudy&)> add;
};

// Finds the object of a figure; null: the scenario was not asked for it.
using FindObject = const void* (*)(const ScenarioStudy&);

Column figureColumn(const Figure& figure, FindObject find, std::string_view name = {}) {
    return {std::string(name.empty() ? figure.key : name),
            [&figure, find](CsvText& csv, const ScenarioStudy& scenario) {
                if (const void* object = find(scenario))
                    addFigures(csv, {{&figure, 1}, object});
                else
                    csv.nothing();
            }};
}

// A text that one of its answers states.
template <class T>
Column textColumn(std::string name, std::optional<T> ScenarioAnswers::*answer, std::string T::*text) {
    return {std::move(name), [answer, text](CsvText& csv, const ScenarioStudy& scenario) {
                const std::optional<T>& one = scenario.answers.*answer;
                csv.text(one ? (*one).*text : std::string());
            }};
}

// The change of the shadow area stands behind the shadow area.
void addMeasured(std::vector<Column>& columns, const ScenarioStudies& scenarios) {
    for (const Figure& figure : shadowFigures().rows()) {
        if (!figure.inTable) continue;
        columns.push_back(figureColumn(
            figure, [](const ScenarioStudy& one) -> const void* { return &one.study->statistics; }));
        if (figure.key == "shadow_area_m2")
            columns.push_back({"shadow_area_change_m2", [&](CsvText& csv, const ScenarioStudy& scenario) {
                                   csv.number(computeShadowAreaChange(scenarios, scenario), 1);
                               }});
    }
}

// A scenario without such figures has no tree that reaches a receiver: its figures are those without trees.
template <TreeColumns column>
const void* findShade(const ScenarioStudy& one) {
    const auto found = std::ranges::find(one.withTrees, column, &ShadedFigures::column);
    return found == one.withTrees.end() ? &one.study->statistics : &found->figures;
}

template <TreeColumns column>
const void* findShadedScore(const ScenarioStudy& one) {
    if (!one.answers.score) return nullptr;
    const auto found = std::ranges::find(one.answers.score->withTrees, column, &ShadedScore::column);
    const bool isThere = found != one.answers.score->withTrees.end();
    return isThere ? static_cast<const ScoreTotals*>(&*found) : &one.answers.score->totals;
}

template <TreeColumns column>
void addTrees(std::vector<Column>& columns, const ScenarioStudies& scenarios) {
    if (!isShaded(scenarios, column)) return;
    for (const Figure& figure : treeFigures(column))
        if (figure.inTable) columns.push_back(figureColumn(figure, &findShade<column>));
    for (const Figure& figure : scoreFiguresWithTrees(column))
        columns.push_back(figureColumn(figure, &findShadedScore<column>));
}

void addTowers(std::vector<Column>& columns) {
    columns.push_back(
        {"height_m", [](CsvText& csv, const ScenarioStudy& one) { csv.number(one.heightM, 1); }});
    columns.push_back({"gross_floor_m2", [](CsvText& csv, const ScenarioStudy& one) {
                           csv.number(sumFloorAreaM2(one.uses), 1);
                       }});
}

void addImpact(std::vector<Column>& columns) {
    const FindObject impact = [](const ScenarioStudy& one) -> const void* {
        return one.answers.impact ? &one.answers.impact->figures : nullptr;
    };
    const FindObject gross = [](const ScenarioStudy& one) -> const void* {
        return one.answers.impact ? &one.answers.impact->figures.gross : nullptr;
    };
    const auto all = impactFigures().rows();
    columns.push_back(textColumn("impact_baseline", &ScenarioAnswers::impact, &ScenarioImpact::baseline));
    columns.push_back(figureColumn(findFigure(all, "shadow_area_change_m2"), impact, "impact_m2"));
    columns.push_back(figureColumn(findFigure(all, "threshold_min"), impact, "impact_threshold_min"));
    for (const Figure& figure : figuresByThreshold()) columns.push_back(figureColumn(figure, gross));
}

void addScore(std::vector<Column>& columns) {
    const FindObject score = [](const ScenarioStudy& one) -> const void* {
        return one.answers.score ? &one.answers.score->totals : nullptr;
    };
    columns.push_back(textColumn("weights", &ScenarioAnswers::score, &ScenarioScore::weights));
    for (const Figure& figure : scoreFigures().rows())
        if (figure.inFiles && figure.use == FigureUse::result) columns.push_back(figureColumn(figure, score));
}

void addVerdicts(std::vector<Column>& columns) {
    const FindObject verdicts = [](const ScenarioStudy& one) -> const void* {
        return one.answers.verdicts ? &one.answers.verdicts->counts : nullptr;
    };
    columns.push_back(textColumn("rule", &ScenarioAnswers::verdicts, &ScenarioVerdicts::rule));
    columns.push_back(textColumn("rule_baseline", &ScenarioAnswers::verdicts, &ScenarioVerdicts::baseline));
    for (const Figure& figure : verdictFigures().rows()) columns.push_back(figureColumn(figure, verdicts));
}

std::vector<Column> listColumns(const ScenarioStudies& scenarios) {
    std::vector<Column> columns{
        {"name", [](CsvText& csv, const ScenarioStudy& one) { csv.text(one.name); }},
        {"changes", [](CsvText& csv, const ScenarioStudy& one) { csv.whole(countChanges(one)); }}};
    addMeasured(columns, scenarios);
    addTowers(columns);
    addImpact(columns);
    addScore(columns);
    addTrees<TreeColumns::evergreen>(columns, scenarios);
    addTrees<TreeColumns::seasonal>(columns, scenarios);
    addVerdicts(columns);
    return columns;
}

}  // namespace

std::string scenariosCsv(const ScenarioStudies& scenarios) {
    const std::vector<Column> columns = listColumns(scenarios);
    std::vector<std::string> names;
    std::ranges::transform(columns, std::back_inserter(names), &Column::name);
    CsvText csv(withSourceColumns(std::move(names)));
    for (const ScenarioStudy& scenario : scenarios) {
        for (const Column& column : columns) column.add(csv, scenario);
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
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (isShaded(scenarios, column)) {
            json["definitions"].update(definitionsJson(treeFigures(column)));
            json["definitions"].update(definitionsJson(scoreFiguresWithTrees(column)));
        }
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
