#include "scenarios/weights/score_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "core/describe/command_options.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/error_text.h"
#include "scenarios/settings_json.h"

namespace noonmark {

namespace {

// The same figures of the region, of a month and of an interval.
template <class R>
Figure weightedShade() {
    return figure(
        &R::weightedShadeM2h,
        {.key = "weighted_shade_m2h",
         .label = NM_TEXT("Weighted shade"),
         .definition =
             NM_TEXT("sum over the steps of weight x hours in shadow x cell area, m2 h over the period; how "
                     "the weight table is cut into intervals does not change it"),
         .valueIfMissing = std::numeric_limits<double>::quiet_NaN(),
         .unit = FigureUnit::squareMetreHours,
         .better = Better::higher,
         .isChange = true});
}

template <class R>
Figure scoreM2() {
    return figure(
        &R::scoreM2,
        {.key = "score_m2",
         .label = NM_TEXT("Shadow score"),
         .definition =
             NM_TEXT("sum over the intervals of the weight table of weight x share of the interval's sunlit "
                     "time in shadow, times cell area; an interval that is cut in two counts twice"),
         .unit = FigureUnit::squareMetres,
         .better = Better::higher,
         .isChange = true});
}

template <class R>
Figure shadowArea() {
    return figure(&R::shadowAreaM2, findFigure(shadowFigures().rows(), "shadow_area_m2"));
}

double scorePerArea(const ScoreTotals& totals) {
    return totals.scoreM2 / std::max(1.0, totals.receiverAreaM2);
}

// The figures that a project kept of its scenarios did not state it at first.
Figure receiverArea() {
    Figure row = figure(&ScoreTotals::receiverAreaM2, findFigure(shadowFigures().rows(), "receiver_area_m2"));
    row.valueIfMissing = std::numeric_limits<double>::quiet_NaN();
    return row;
}

}  // namespace

const Figures<ScoreTotals>& scoreFigures() {
    static const Figures<ScoreTotals> figures{
        receiverArea(), figure(&ScoreTotals::waterM2, findFigure(shadowFigures().rows(), "water_m2")),
        weightedShade<ScoreTotals>(), scoreM2<ScoreTotals>(),
        derivedFigure(&scorePerArea, {.key = "score_per_m2",
                                      .label = NM_TEXT("Score per m² of ground"),
                                      .definition = NM_TEXT("score divided by the area of all receivers"),
                                      .shownDecimals = 3,
                                      .isChange = true,
                                      .inFiles = false})};
    return figures;
}

const Figures<MonthFigures>& scoreMonthFigures() {
    static const Figures<MonthFigures> figures{
        figure(&MonthFigures::sunlitMinutes,
               {.key = "sunlit_min",
                .label = NM_TEXT("Sunlit time"),
                .definition = NM_TEXT("minutes of the period with the sun above the horizon"),
                .unit = FigureUnit::minutes,
                .use = FigureUse::basis,
                .shownDecimals = 0}),
        weightedShade<MonthFigures>(), shadowArea<MonthFigures>(), scoreM2<MonthFigures>()};
    return figures;
}

const Figures<IntervalFigures>& scoreIntervalFigures() {
    static const Figures<IntervalFigures> figures{
        figure(&IntervalFigures::weight,
               {.key = "weight",
                .label = NM_TEXT("Weight"),
                .definition = NM_TEXT("from -1 (shadow is unwanted) to 1 (shade is wanted)"),
                .decimals = 3,
                .shownDecimals = 3}),
        weightedShade<IntervalFigures>(), shadowArea<IntervalFigures>(), scoreM2<IntervalFigures>()};
    return figures;
}

std::span<const Figure> scoreFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(scoreFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(scoreFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::span<const Figure> scoreMonthFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(scoreMonthFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(scoreMonthFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::span<const Figure> scoreIntervalFiguresWithTrees(TreeColumns column) {
    // The first one is the weight, which trees do not change.
    static const std::span<const Figure> rows = scoreIntervalFigures().rows().subspan(1);
    static const FiguresWithTrees evergreen(rows, TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(rows, TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::vector<FigureLine> listScoreLines(const Score& score) {
    std::vector<FigureLine> lines = listLines(scoreFigures().of(score));
    for (const ShadedScore& with : score.withTrees)
        std::ranges::move(
            listLines({scoreFiguresWithTrees(with.column), static_cast<const ScoreTotals*>(&with)}),
            std::back_inserter(lines));
    return lines;
}

namespace {

Sentence describeBalance(const ScoreTotals& score, const std::string& scenario) {
    const Amount total{score.scoreM2, FigureUnit::squareMetres, 0, true};
    if (score.scoreM2 > 0)
        return {NM_TEXT("%1 scores %2: wanted shade outweighs unwanted shadow"), {scenario, total}};
    if (score.scoreM2 < 0)
        return {NM_TEXT("%1 scores %2: unwanted shadow outweighs wanted shade"), {scenario, total}};
    return {NM_TEXT("%1 scores 0: wanted shade and unwanted shadow weigh the same"), {scenario}};
}

Bars monthBars(std::span<const MonthFigures> months, std::string_view title, double MonthFigures::*value) {
    Bars bars{.title = title};
    for (const MonthFigures& month : months) bars.groups.push_back({month.month, {month.*value}});
    return bars;
}

Bars weightedBars(std::span<const MonthFigures> months) {
    Bars bars = monthBars(months, NM_TEXT("Weighted shade by month, m² h"), &MonthFigures::weightedShadeM2h);
    for (Bars::Group& group : bars.groups)
        group.tone = group.values.front() < 0 ? BarTone::loss : BarTone::gain;
    return bars;
}

// Where sun is shown, the rest of the receivers' area.
Bars areaBars(const ScoreTotals& score, std::span<const MonthFigures> months, ShownAs show) {
    if (show == ShownAs::shadow)
        return monthBars(months, NM_TEXT("Shadow area by month, m²"), &MonthFigures::shadowAreaM2);
    Bars bars = monthBars(months, NM_TEXT("Sunlit area by month, m²"), &MonthFigures::shadowAreaM2);
    for (Bars::Group& group : bars.groups) {
        group.values.front() = score.receiverAreaM2 - group.values.front();
        group.tone = BarTone::sun;
    }
    return bars;
}

}  // namespace

AnswerPage makePage(const ScoreTotals& score, std::span<const MonthFigures> months,
                    const std::string& scenario, ShownAs show) {
    AnswerPage page{describeBalance(score, scenario)};
    if (!std::isnan(score.weightedShadeM2h))
        page.findings.push_back({NM_TEXT("Weighted by time: %1."),
                                 {Amount{score.weightedShadeM2h, FigureUnit::squareMetreHours, 0, true}}});
    page.charts = {weightedBars(months), areaBars(score, months, show)};
    return page;
}

using Json = nlohmann::ordered_json;

namespace {

std::string formatText(std::chrono::year_month month) {
    return fmt::format("{:04}-{:02}", int(month.year()), unsigned(month.month()));
}

// Each with its name first.
template <class R, class Name>
Json listJson(const std::vector<R>& list, const char* key, Name nameOf, const Figures<R>& figures) {
    Json json = Json::array();
    for (const R& one : list) {
        Json& object = json.emplace_back(Json{{key, nameOf(one)}});
        object.update(figuresJson(figures.of(one)));
    }
    return json;
}

// Adds to each object of a list what is measured of it with trees.
template <class R>
void addToEach(Json& list, const std::vector<ShadedScore>& withTrees, std::vector<R> ShadedScore::*ofColumn,
               std::span<const Figure> (*figuresOf)(TreeColumns)) {
    for (const ShadedScore& with : withTrees)
        for (std::size_t i = 0; i < list.size(); ++i)
            list[i].update(figuresJson({figuresOf(with.column), &(with.*ofColumn).at(i)}));
}

std::string monthOf(const MonthFigures& month) { return formatText(month.month); }

}  // namespace

Result<std::string> makeRepeatCommand(const ScoreAnswer& answer, std::size_t width) {
    return makeRepeatCommand(
        projectQuestion("score", answer.settings, answer.provenance, answer.score.engineKey,
                        {{flags::weights, {answer.weights.name}}}),
        width);
}

Json monthsJson(const std::vector<MonthFigures>& months, const std::vector<ShadedScore>& withTrees) {
    Json json = listJson(months, "month", &monthOf, scoreMonthFigures());
    addToEach(json, withTrees, &ShadedScore::months, &scoreMonthFiguresWithTrees);
    return json;
}

std::string scoreJson(const ScoreAnswer& answer) {
    Json json = settingsJson(answer.settings);
    addProvenance(json, answer.provenance);
    addRepeat(json, makeRepeatCommand(answer, std::numeric_limits<std::size_t>::max()));
    json["scenario"] = answer.scenario;
    json["weights"] = answer.weights.name;
    json["engine_settings"] = answer.score.engine;
    json.update(figuresJson(scoreFigures().of(answer.score)));
    const std::vector<ShadedScore>& withTrees = answer.score.withTrees;
    for (const ShadedScore& with : withTrees)
        json.update(
            figuresJson({scoreFiguresWithTrees(with.column), static_cast<const ScoreTotals*>(&with)}));
    if (!withTrees.empty()) json["engine_trees"] = answer.score.treesHow;
    json["errors"] = errorsJson(answer.score.errors);
    json["months"] = monthsJson(answer.score.months, withTrees);
    json["intervals"] = listJson(
        answer.score.intervals, "name", [](const IntervalFigures& interval) { return interval.name; },
        scoreIntervalFigures());
    addToEach(json["intervals"], withTrees, &ShadedScore::intervals, &scoreIntervalFiguresWithTrees);
    json["definitions"] = definitionsJson(scoreMonthFigures().rows());
    for (const ShadedScore& with : withTrees)
        json["definitions"].update(definitionsJson(scoreMonthFiguresWithTrees(with.column)));
    json["warnings"] = warningsJson(answer.score.warnings);
    return toJsonText(json);
}

std::string scoreCsv(const ScoreAnswer& answer) {
    std::vector<std::string> columns = listColumns(scoreMonthFigures().rows());
    columns.insert(columns.begin(), "month");
    for (const ShadedScore& with : answer.score.withTrees)
        std::ranges::move(listColumns(scoreMonthFiguresWithTrees(with.column)), std::back_inserter(columns));
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(answer.provenance);
    for (std::size_t i = 0; i < answer.score.months.size(); ++i) {
        const MonthFigures& month = answer.score.months[i];
        csv.text(monthOf(month));
        addFigures(csv, scoreMonthFigures().of(month));
        for (const ShadedScore& with : answer.score.withTrees)
            addFigures(csv, {scoreMonthFiguresWithTrees(with.column), &with.months.at(i)});
        addSource(csv, source);
        csv.endRow();
    }
    return csv.take();
}

}  // namespace noonmark
