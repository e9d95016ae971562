#include "app/report/scenarios/scenario_study.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

#include "app/report/scenarios/scenario_months.h"
#include "core/describe/command_options.h"
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

ScenarioSun makeScenarioSun(const SunByPlace& sun) {
    return {sun.places.size(), sun.settings.enoughHours, sun.months, averagePlaces(sun)};
}

std::size_t countChanges(const ScenarioStudy& scenario) {
    const auto& project = scenario.study->provenance.project;
    return project ? project->scenario.edits.size() : 0;
}

// The engine's words also state counts, which differ from city to city.
bool areComparable(const Study& before, const Study& after) {
    return before.settings == after.settings && before.field.grid == after.field.grid &&
           before.field.engineKey == after.field.engineKey;
}

ImpactFigures compareStudies(const Study& before, const Study& after, double thresholdMin) {
    const std::vector<CellChange> none(after.field.grossMin.size(), CellChange::none);
    return computeFigures(computeDifference(before.field, after.field, none), thresholdMin);
}

double computeShadowAreaChange(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    const Study &first = *scenarios.front().study, &study = *scenario.study;
    if (first.field.grid != study.field.grid) return std::numeric_limits<double>::quiet_NaN();
    return compareStudies(first, study).shadowAreaChangeM2;
}

namespace {

// What some scenarios have and others lack cannot be asked for in one command.
template <class Has>
Result<bool> haveAll(const ScenarioStudies& scenarios, const char* what, const char* advice, const Has& has) {
    const auto lacking = std::ranges::find_if_not(scenarios, has);
    if (lacking == scenarios.end()) return true;
    if (std::ranges::none_of(scenarios, has)) return false;
    return failure(std::string("No command can repeat this result yet: only some scenarios are ") + what,
                   lacking->name, advice);
}

Result<void> addScoring(std::vector<CommandOption>& options, const ScenarioStudies& scenarios) {
    const auto& weights = scenarios.front().answers.score;
    const auto all =
        haveAll(scenarios, "scored with these weights",
                "Press Score all in the panel Scenarios, then export again", [&](const ScenarioStudy& one) {
                    return one.answers.score && (!weights || one.answers.score->weights == weights->weights);
                });
    if (!all) return tl::make_unexpected(all.error());
    if (!*all) return {};
    const auto without = std::ranges::find_if(scenarios, [](const ScenarioStudy& one) {
        return !one.withTrees.empty() && one.answers.score->withTrees.empty();
    });
    if (without != scenarios.end())
        return failure(
            "No command can repeat this result: its shadow is measured with trees, its scores without",
            without->name, "Compute the scores again, then export again");
    options.push_back({flags::weights, {weights->weights}});
    return {};
}

const std::string& cityOf(const ScenarioStudy& scenario) {
    return scenario.study->provenance.project->scenario.citySha256;
}

// Of one that is the baseline itself, or has its buildings, there is no comparison.
bool isLike(const ScenarioStudy& one, const std::string& baseline, const ScenarioStudies& scenarios) {
    if (one.name == baseline) return true;
    const auto base = std::ranges::find(scenarios, baseline, &ScenarioStudy::name);
    return base != scenarios.end() && cityOf(*base) == cityOf(one);
}

Result<void> addComparing(std::vector<CommandOption>& options, const ScenarioStudies& scenarios) {
    const auto first = std::ranges::find_if(scenarios, [](const auto& one) { return !!one.answers.impact; });
    if (first == scenarios.end()) return {};
    const ScenarioImpact& impact = *first->answers.impact;
    const auto isAlike = [&](const ScenarioStudy& one) {
        const auto& other = one.answers.impact;
        return other ? other->baseline == impact.baseline &&
                           other->figures.thresholdMin == impact.figures.thresholdMin
                     : isLike(one, impact.baseline, scenarios);
    };
    const auto all = haveAll(scenarios, "compared with this baseline",
                             "Compare the others, or press Measure all with the baseline among them, then "
                             "export again",
                             isAlike);
    if (!all) return tl::make_unexpected(all.error());
    options.push_back({flags::baseline, {impact.baseline}});
    options.push_back({flags::threshold, {fmt::format("{}", impact.figures.thresholdMin)}});
    return {};
}

// Each scenario chooses an engine of its own, if one is to be chosen.
std::string engineOf(const ScenarioStudies& scenarios) {
    const std::string& key = scenarios.front().study->field.engineKey;
    const bool isOne = std::ranges::all_of(
        scenarios, [&](const ScenarioStudy& one) { return one.study->field.engineKey == key; });
    return isOne ? key : std::string();
}

}  // namespace

Result<std::string> makeRepeatCommand(const ScenarioStudies& scenarios, std::size_t width) {
    std::vector<CommandOption> options;
    for (const ScenarioStudy& one : scenarios) {
        const auto& project = one.study->provenance.project;
        if (!project || !project->saved())
            return failure(
                "No command can repeat this result yet: the project has not been saved in the state that was "
                "measured",
                one.name, "Save the project, then export again");
        if (&one != &scenarios.front()) options.push_back({flags::scenario, {one.name}});
    }
    for (const auto add : {&addScoring, &addComparing})
        if (const auto added = add(options, scenarios); !added) return tl::make_unexpected(added.error());
    const Study& first = *scenarios.front().study;
    RepeatQuestion question = projectQuestion("scenarios", first.settings, first.provenance,
                                              engineOf(scenarios), std::move(options));
    question.settings.byMonth = first.settings.byMonth;
    question.needsProject = true;
    return makeRepeatCommand(question, width);
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

std::vector<std::string> verdictColumns() {
    std::vector<Column> columns;
    addVerdicts(columns);
    std::vector<std::string> names;
    std::ranges::transform(columns, std::back_inserter(names), &Column::name);
    return names;
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
    addRepeat(json, makeRepeatCommand(scenarios, std::numeric_limits<std::size_t>::max()));
    json["definitions"] = definitionsJson(shadowFigures().rows());
    json["definitions"].update(definitionsJson(scoreFigures().rows()));
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (isShaded(scenarios, column)) {
            json["definitions"].update(definitionsJson(treeFigures(column)));
            json["definitions"].update(definitionsJson(scoreFiguresWithTrees(column)));
        }
    json["definitions"].update(definitionsJson(months));
    json["definitions"].update(
        {{"shadow_area_change_m2",
          "change of the shadow area from the scenario named by compared_with, on the receivers of both: "
          "ground that is built over in either does not count"},
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
          "figures of each month, as far as they were computed, and their changes: the figure minus that of "
          "the scenario named by compared_with, so that ground that is built over counts in them"},
         {"gross", "minutes in shadow per day, mean over the days"},
         {"continuous", "longest unbroken run in shadow on any day, minutes"}});
    return toJsonText(json);
}

}  // namespace noonmark
