#include "scenarios/impact/impact_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/describe/command_options.h"
#include "core/describe/field_json.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/measures/statistics.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/error_text.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/impact/proposal_region.h"
#include "scenarios/settings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

const std::string shadowAreaChangeKey = "shadow_area_change_m2";

Json changeJson(const ChangeFigures& figures) {
    return std::isnan(figures.meanMin) ? Json() : figuresJson(changeFigures().of(figures));
}

}  // namespace

Json figuresJson(const ImpactFigures& figures) {
    Json json = figuresJson(impactFigures().of(figures));
    json["gross"] = changeJson(figures.gross);
    json["continuous"] = changeJson(figures.continuous);
    for (const ShadeChange& shade : figures.withTrees) {
        const std::string suffix = suffixOf(shade.column);
        json[shadowAreaChangeKey + suffix] = shade.shadowAreaChangeM2;
        json["gross" + suffix] = changeJson(shade.gross);
        json["continuous" + suffix] = changeJson(shade.continuous);
    }
    return json;
}

namespace {

Json figuresJson(const Impact& impact, const std::vector<double>& thresholds) {
    Json json = Json::array();
    for (const double threshold : thresholds) json.push_back(figuresJson(computeFigures(impact, threshold)));
    return json;
}

Json figuresJson(const ImpactStudy& study, const std::vector<double>& thresholds) {
    Json json = Json::array();
    for (const double threshold : thresholds) json.push_back(figuresJson(computeFigures(study, threshold)));
    return json;
}

std::string describeColumn(TreeColumns column) {
    return fmt::format("with trees{}, weighted by what buildings and crowns take from the sun",
                       column == TreeColumns::evergreen ? " as evergreens" : " and their seasons");
}

void defineColumns(Json& json, const ImpactStudy& study) {
    for (const ShadeImpact& shade : study.withTrees)
        for (const std::string& key : {shadowAreaChangeKey, std::string("gross"), std::string("continuous")})
            json[key + suffixOf(shade.column)] = fmt::format("{} {}", key, describeColumn(shade.column));
}

Json definitions() {
    Json json{
        {"change", "the field of `to` minus the field of `from`, same engine, steps and receivers"},
        {"error", "of the change on a sample of receivers that the ray reference traced in both cities"},
        {"proposal_in_region", "how much of what `to` builds stands in the region: whole, part or none"},
        {"changes_at_edge",
         "whether shadow changes beside the region's edge by more than the first threshold, so that some of "
         "the change probably lies beyond"},
        {"by_building", "`to` minus `to` without this building: its sole contribution"}};
    json.update(definitionsJson(impactFigures().rows()));
    json.update(definitionsJson(changeFigures().rows()));
    return json;
}

std::vector<std::string> columnsOf(const ImpactStudy& study) {
    std::vector<std::string> columns{"id", "name"};
    std::ranges::move(listColumns(impactFigures().rows()), std::back_inserter(columns));
    std::ranges::move(listColumns(changeFigures().rows()), std::back_inserter(columns));
    for (const std::string& column : listColumns(figuresByThreshold()))
        columns.push_back("continuous_" + column);
    for (const ShadeImpact& shade : study.withTrees) {
        columns.push_back(shadowAreaChangeKey + suffixOf(shade.column));
        for (const std::string& column : listColumns(changeFigures().rows()))
            columns.push_back(column + suffixOf(shade.column));
    }
    return withSourceColumns(std::move(columns));
}

// A building's own contribution is not measured with trees: its fields of them are empty.
void addShades(CsvText& csv, const ImpactStudy& study, const ImpactFigures& figures) {
    static const Figure& area = findFigure(impactFigures().rows(), shadowAreaChangeKey);
    for (std::size_t i = 0; i < study.withTrees.size(); ++i) {
        const bool measured = i < figures.withTrees.size();
        const ShadeChange shade =
            measured ? figures.withTrees[i]
                     : ShadeChange{.gross = notComputed(),
                                   .shadowAreaChangeM2 = std::numeric_limits<double>::quiet_NaN()};
        ImpactFigures whole;
        whole.shadowAreaChangeM2 = shade.shadowAreaChangeM2;
        addFigures(csv, {{&area, 1}, &whole});
        addFigures(csv, changeFigures().of(shade.gross));
    }
}

void addLine(CsvText& csv, const ImpactStudy& study, const std::string& id, const std::string& name,
             const ImpactFigures& figures, const SourceValues& source) {
    csv.text(id).text(name);
    addFigures(csv, impactFigures().of(figures));
    addFigures(csv, changeFigures().of(figures.gross));
    addFigures(csv, {figuresByThreshold(), &figures.continuous});
    addShades(csv, study, figures);
    addSource(csv, source);
    csv.endRow();
}

std::vector<CommandOption> optionsOf(const ImpactAnswer& answer) {
    std::vector<CommandOption> options{{flags::from, {answer.from}}, {flags::to, {answer.to}}};
    std::ranges::move(listOptions(impactFields().of(answer.settings)), std::back_inserter(options));
    return options;
}

}  // namespace

ComparisonFigures computeFigures(const ImpactAnswer& answer) {
    const Impact& total = answer.study.total;
    ComparisonFigures figures{answer.from,  answer.to,    {}, {}, statePeriod(answer.settings.study.period),
                              total.engine, total.waterM2};
    for (const double threshold : answer.settings.thresholdsMin)
        figures.all.push_back(computeFigures(answer.study, threshold));
    for (const BuildingImpact& building : answer.study.byBuilding)
        figures.byBuilding.push_back(
            {building.name.empty() ? building.id : building.name,
             computeFigures(building.impact, answer.settings.thresholdsMin.front())});
    if (answer.study.error) figures.errors = listErrors(*answer.study.error, true);
    return figures;
}

namespace {

void addChange(std::vector<FigureLine>& lines, std::string_view measure, const ChangeFigures& change,
               std::optional<double> thresholdMin, ShownAs show) {
    const DescribedFigures figures = changeFigures().of(change);
    for (const Figure& figure : figures.figures)
        if (figure.byThreshold == thresholdMin.has_value() && isShownAs(figure, show))
            lines.push_back({.figure = &figure,
                             .value = figures.get(figure),
                             .measure = measure,
                             .thresholdMin = thresholdMin});
}

}  // namespace

namespace {

std::string_view measureOf(TreeColumns column, ShownAs show) {
    const bool evergreen = column == TreeColumns::evergreen;
    if (show == ShownAs::shadow)
        return evergreen ? NM_TEXT("Gross, trees as evergreens") : NM_TEXT("Gross, trees with their seasons");
    return evergreen ? NM_TEXT("Sun, trees as evergreens") : NM_TEXT("Sun, trees with their seasons");
}

}  // namespace

// The longest run in shadow has no complement in sun, so it stays in minutes.
std::vector<FigureLine> listLines(const ComparisonFigures& figures, ShownAs show) {
    constexpr std::string_view continuous = NM_TEXT("Continuous");
    const std::string_view gross = show == ShownAs::shadow ? NM_TEXT("Gross") : NM_TEXT("Sun");
    const ImpactFigures& first = figures.all.front();
    const FigureContext context{.show = show};
    std::vector<FigureLine> lines = listLines(impactFigures().of(first), FigureUse::result, context);
    for (const ImpactFigures& one : figures.all) addChange(lines, gross, one.gross, one.thresholdMin, show);
    for (const ImpactFigures& one : figures.all)
        if (hasRuns(one)) addChange(lines, continuous, one.continuous, one.thresholdMin, ShownAs::shadow);
    if (!hasRuns(first))
        lines.push_back({.figure = &findFigure(changeFigures().rows(), "mean_min"),
                         .value = first.continuous.meanMin,
                         .measure = continuous});
    addChange(lines, gross, first.gross, std::nullopt, show);
    for (const ImpactFigures& one : figures.all)
        for (const ShadeChange& shade : one.withTrees)
            addChange(lines, measureOf(shade.column, show), shade.gross, one.thresholdMin, show);
    for (const ShadeChange& shade : first.withTrees)
        addChange(lines, measureOf(shade.column, show), shade.gross, std::nullopt, show);
    std::ranges::copy(listLines(impactFigures().of(first), FigureUse::basis), std::back_inserter(lines));
    if (figures.waterM2 > 0)
        lines.push_back({&findFigure(shadowFigures().rows(), "water_m2"), figures.waterM2});
    return lines;
}

std::vector<FigureLine> listThresholdLines(const ImpactFigures& figures) {
    std::vector<FigureLine> lines;
    addChange(lines, {}, figures.gross, figures.thresholdMin, ShownAs::shadow);
    return lines;
}

namespace {

Sentence describeChange(const std::string& scenario, const ChangeFigures& change, ShownAs show) {
    const auto minutes = [](double value) { return Amount{value, FigureUnit::minutes}; };
    if (change.maxMoreShadowMin == 0 && change.maxLessShadowMin == 0)
        return {show == ShownAs::shadow ? NM_TEXT("%1 changes no shadow here")
                                        : NM_TEXT("%1 changes no sun here"),
                {scenario}};
    const auto area = [](double m2) { return Amount{m2, FigureUnit::squareMetres}; };
    constexpr double minMeanMin = 0.5;  // less reads "0 min": the region is large, the change small
    if (std::abs(change.meanMin) < minMeanMin && change.meanMin >= 0)
        return {NM_TEXT("%1 takes sun from %2, at most %3 a day at one spot"),
                {scenario, area(change.anyMoreShadowM2), minutes(change.maxMoreShadowMin)}};
    if (std::abs(change.meanMin) < minMeanMin)
        return {NM_TEXT("%1 gives sun to %2, at most %3 a day at one spot"),
                {scenario, area(change.anyLessShadowM2), minutes(change.maxLessShadowMin)}};
    if (change.meanMin >= 0)
        return {NM_TEXT("%1 takes %2 of sun a day on average, at most %3 at one spot"),
                {scenario, minutes(change.meanMin), minutes(change.maxMoreShadowMin)}};
    return {NM_TEXT("%1 gives %2 of sun a day on average, at most %3 at one spot"),
            {scenario, minutes(-change.meanMin), minutes(change.maxLessShadowMin)}};
}

Sentence describeAreas(const ImpactFigures& figures, ShownAs show) {
    const auto area = [](double m2) { return Amount{m2, FigureUnit::squareMetres}; };
    return {show == ShownAs::shadow
                ? NM_TEXT("More shadow on %1, less on %2; by more than %3 a day on %4 and %5.")
                : NM_TEXT("Less sun on %1, more on %2; by more than %3 a day on %4 and %5."),
            {area(figures.gross.anyMoreShadowM2), area(figures.gross.anyLessShadowM2),
             Amount{figures.thresholdMin, FigureUnit::minutes}, area(figures.gross.moreShadowM2),
             area(figures.gross.lessShadowM2)}};
}

}  // namespace

AnswerPage makePage(const Impact& impact, const ComparisonFigures& figures, ShownAs show) {
    const ImpactFigures& first = figures.all.front();
    if (impact.sunlitMinutesPerDay <= 1)
        return {{NM_TEXT("%1 changes the shadow by %2 at this moment"),
                 {figures.to, Amount{first.shadowAreaChangeM2, FigureUnit::squareMetres, 0, true}}}};
    return {describeChange(figures.to, first.gross, show),
            {describeAreas(first, show)},
            {makeChangeHistogram(impact.grossMin, impact.grid.cellAreaM2(), noChangeMin, show)}};
}

const Impact& impactOfColumn(const ImpactStudy& study, TreeColumns column) {
    const auto found = std::ranges::find(study.withTrees, column, &ShadeImpact::column);
    return found == study.withTrees.end() ? study.total : found->impact;
}

AnswerPage makePage(const ImpactAnswer& answer, const LegendChoice& shown) {
    const Impact& impact = impactOfColumn(answer.study, shown.trees);
    ComparisonFigures figures = computeFigures(answer);
    const bool isWithTrees = &impact != &answer.study.total;
    if (isWithTrees) figures.all.front() = computeFigures(impact, answer.settings.thresholdsMin.front());
    AnswerPage page = makePage(impact, figures, shown.show);
    if (isWithTrees) page.findings.insert(page.findings.begin(), nameColumn(shown.trees));
    if (auto beyond = describeBeyond(answer)) page.findings.push_back(*std::move(beyond));
    return page;
}

Result<std::string> makeRepeatCommand(const ImpactAnswer& answer, std::size_t width) {
    return makeRepeatCommand(projectQuestion("impact", answer.settings.study, answer.provenance,
                                             answer.study.after.engineKey, optionsOf(answer)),
                             width);
}

std::string impactJson(const ImpactAnswer& answer) {
    const Impact& total = answer.study.total;
    Json json = settingsJson(answer.settings.study);
    json.update(fieldsJson(impactFields().of(answer.settings)));
    json["from"] = answer.from;
    json["to"] = answer.to;
    json["engine_settings"] = total.engine;
    json["steps"] = answer.study.sun.steps.size();
    json["period"]["counted_step_min"] = total.stepMinutes;
    json["sunlit_min_per_day"] = total.sunlitMinutesPerDay;
    json["water_m2"] = total.waterM2;
    json["error"] = answer.study.error ? errorJson(*answer.study.error, answer.study.frame) : Json();
    json["errors"] = answer.study.error ? errorsJson(listErrors(*answer.study.error, true)) : Json();
    json["impact"] = figuresJson(answer.study, answer.settings.thresholdsMin);
    const BeyondRegion beyond = findBeyond(answer);
    json["proposal_in_region"] = std::array{"whole", "part", "none"}[std::size_t(beyond.proposal)];
    json["changes_at_edge"] = beyond.changesAtEdge;
    json["by_building"] = Json::array();
    for (const BuildingImpact& building : answer.study.byBuilding)
        json["by_building"].push_back(
            {{"id", building.id},
             {"name", building.name},
             {"impact", figuresJson(building.impact, answer.settings.thresholdsMin)}});
    addProvenance(json, answer.provenance);
    addRepeat(json, makeRepeatCommand(answer, std::numeric_limits<std::size_t>::max()));
    json["definitions"] = definitions();
    defineColumns(json["definitions"], answer.study);
    json["warnings"] = warningsJson(total.warnings);
    return toJsonText(json);
}

std::string impactCsv(const ImpactAnswer& answer) {
    CsvText csv(columnsOf(answer.study));
    const SourceValues source = sourceValues(answer.provenance);
    for (const double threshold : answer.settings.thresholdsMin)
        addLine(csv, answer.study, "", "all", computeFigures(answer.study, threshold), source);
    for (const BuildingImpact& building : answer.study.byBuilding)
        for (const double threshold : answer.settings.thresholdsMin)
            addLine(csv, answer.study, building.id, building.name, computeFigures(building.impact, threshold),
                    source);
    return csv.take();
}

}  // namespace noonmark
