#include "core/measures/shadow_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/describe/text.h"
#include "core/measures/statistics.h"

namespace noonmark {

namespace {

Sentence describeMoment(const ShadowStatistics& statistics, const std::string& where) {
    const Amount shade{statistics.shadowAreaM2 / statistics.receiverAreaM2, FigureUnit::share};
    if (where.empty()) return {NM_TEXT("%1 of the area in shadow"), {shade}};
    return {NM_TEXT("%1: %2 in shadow"), {where, shade}};
}

// Sun beside its share of what is possible, the one that is shown first.
Sentence describeSun(const Amount& sun, const Amount& share, const std::string& where, ShownAs show) {
    if (show == ShownAs::sun && where.empty())
        return {NM_TEXT("%1 of sun a day, %2 of what is possible"), {sun, share}};
    if (show == ShownAs::sun)
        return {NM_TEXT("%1: %2 of sun a day, %3 of what is possible"), {where, sun, share}};
    if (where.empty()) return {NM_TEXT("%1 of the possible sun, %2 a day"), {share, sun}};
    return {NM_TEXT("%1: %2 of the possible sun, %3 a day"), {where, share, sun}};
}

Sentence describeHours(const ShadowField& field, const ShadowStatistics& statistics, const std::string& where,
                       ShownAs show) {
    const double possible = field.sunlitMinutesPerDay;
    const Amount sun{possible - statistics.meanGrossMin, FigureUnit::hours};
    if (show != ShownAs::shadow)
        return describeSun(sun, {1 - statistics.meanGrossMin / possible, FigureUnit::share, 0}, where, show);
    const Amount shade{statistics.meanGrossMin / possible, FigureUnit::share, 0};
    if (where.empty()) return {NM_TEXT("%1 of sun a day, %2 in shade"), {sun, shade}};
    return {NM_TEXT("%1: %2 of sun a day, %3 in shade"), {where, sun, shade}};
}

double sunAreaM2(const ShadowStatistics& statistics) {
    return statistics.receiverAreaM2 - statistics.shadowAreaM2;
}

double minSunMin(const ShadowStatistics& statistics) {
    return std::max(statistics.meanSunMin + statistics.meanGrossMin - statistics.maxGrossMin, 0.0);
}

}  // namespace

AnswerPage makePage(const ShadowField& field, const ShadowStatistics& statistics, const std::string& where,
                    ShownAs show) {
    if (statistics.receivers == 0) return {};
    if (isInstant(field)) return {describeMoment(statistics, where)};
    AnswerPage page{describeHours(field, statistics, where, show)};
    const double possible = field.sunlitMinutesPerDay;
    page.findings.push_back({NM_TEXT("Of %1 a day with the sun up, the darkest spot gets %2."),
                             {Amount{possible, FigureUnit::hours},
                              Amount{possible - statistics.maxGrossMin, FigureUnit::hours}}});
    if (hasRuns(statistics))
        page.findings.push_back({NM_TEXT("The longest unbroken shadow lasts %1."),
                                 {Amount{statistics.maxContinuousMin, FigureUnit::hours}}});
    page.charts.push_back(makeSunHistogram(field));
    return page;
}

const Figures<ShadowStatistics>& shadowFigures() {
    static const Figures<ShadowStatistics> figures{
        figure(&ShadowStatistics::receivers,
               {.key = "receivers",
                .label = NM_TEXT("Receivers"),
                .definition = NM_TEXT("cells or points where shadow is measured"),
                .use = FigureUse::basis}),
        figure(&ShadowStatistics::receiverAreaM2, {.key = "receiver_area_m2",
                                                   .label = NM_TEXT("Area of the receivers"),
                                                   .definition = NM_TEXT("area of all receivers"),
                                                   .unit = FigureUnit::squareMetres,
                                                   .use = FigureUse::basis,
                                                   .inTable = true}),
        figure(&ShadowStatistics::waterM2,
               {.key = "water_m2",
                .label = NM_TEXT("Water left out"),
                .definition = NM_TEXT("area of rivers and lakes in the region, which is no ground"),
                .valueIfMissing = 0,
                .unit = FigureUnit::squareMetres,
                .use = FigureUse::basis,
                .onlyIfPositive = true}),
        figure(&ShadowStatistics::shadowAreaM2,
               {.key = "shadow_area_m2",
                .label = NM_TEXT("Shadow area"),
                .definition =
                    NM_TEXT("sum over the receivers of (share of the sunlit time in shadow x cell area)"),
                .unit = FigureUnit::squareMetres,
                .whole = Whole::area,
                .better = Better::lessShadow,
                .shownWith = ShownWith::shadow,
                .inTable = true}),
        figure(&ShadowStatistics::meanGrossMin,
               {.key = "mean_gross_min",
                .label = NM_TEXT("Mean gross"),
                .definition = NM_TEXT("minutes in shadow per day, mean over days and receivers"),
                .decimals = 3,
                .unit = FigureUnit::minutesADay,
                .whole = Whole::sunlitTime,
                .together = Aggregation::mean,
                .better = Better::lessShadow,
                .shownWith = ShownWith::shadow,
                .inTable = true}),
        figure(&ShadowStatistics::maxGrossMin,
               {.key = "max_gross_min",
                .label = NM_TEXT("Max gross"),
                .definition =
                    NM_TEXT("minutes in shadow per day, mean over the days, at the receiver that has most"),
                .decimals = 3,
                .unit = FigureUnit::minutesADay,
                .whole = Whole::sunlitTime,
                .together = Aggregation::max,
                .better = Better::lessShadow,
                .shownWith = ShownWith::shadow}),
        figure(&ShadowStatistics::meanSunMin,
               {.key = "mean_sun_min",
                .label = NM_TEXT("Mean sun"),
                .definition = NM_TEXT("sunlit time minus gross shadow per day, mean over days and receivers"),
                .decimals = 3,
                .valueIfMissing = std::numeric_limits<double>::quiet_NaN(),
                .unit = FigureUnit::hoursADay,
                .whole = Whole::sunlitTime,
                .together = Aggregation::mean}),
        derivedFigure(&minSunMin,
                      {.key = "least_sun_min",
                       .label = NM_TEXT("Least sun"),
                       .definition = NM_TEXT("sunlit time minus gross shadow per day, at the receiver that "
                                             "has most shadow"),
                       .unit = FigureUnit::hoursADay,
                       .whole = Whole::sunlitTime,
                       .shownWith = ShownWith::sunInstead,
                       .inFiles = false}),
        derivedFigure(&sunAreaM2,
                      {.key = "sun_area_m2",
                       .label = NM_TEXT("Sunlit area"),
                       .definition = NM_TEXT(
                           "sum over the receivers of (share of the sunlit time in the sun x cell area)"),
                       .unit = FigureUnit::squareMetres,
                       .whole = Whole::area,
                       .shownWith = ShownWith::sunInstead,
                       .inFiles = false}),
        figure(&ShadowStatistics::meanContinuousMin,
               {.key = "mean_continuous_min",
                .label = NM_TEXT("Mean continuous"),
                .definition = NM_TEXT("longest unbroken run in shadow on any day, mean over the receivers"),
                .decimals = 3,
                .unit = FigureUnit::minutes,
                .together = Aggregation::mean,
                .better = Better::lessShadow,
                .inTable = true}),
        figure(&ShadowStatistics::maxContinuousMin,
               {.key = "max_continuous_min",
                .label = NM_TEXT("Max continuous"),
                .definition = NM_TEXT("longest unbroken run in shadow at any receiver on any day"),
                .decimals = 3,
                .unit = FigureUnit::minutes,
                .together = Aggregation::max,
                .better = Better::lessShadow,
                .inTable = true}),
    };
    return figures;
}

std::string_view describeTrees(TreeColumns column) {
    if (column == TreeColumns::evergreen) return NM_TEXT("trees as evergreens");
    return column == TreeColumns::seasonal ? NM_TEXT("trees with their seasons") : NM_TEXT("without trees");
}

FiguresWithTrees::FiguresWithTrees(std::span<const Figure> figures, TreeColumns column) {
    const std::string_view with = describeTrees(column);
    for (const Figure& figure : figures) {
        if (figure.use != FigureUse::result || !figure.inFiles) continue;
        Figure row = figure;
        row.key = hold(std::string(figure.key) + suffixOf(column));
        row.label = hold(fmt::format("{}, {}", figure.label, with));
        row.definition = hold(fmt::format("{}; {}, weighted by what buildings and crowns take from the sun",
                                          figure.definition, with));
        rows_.push_back(std::move(row));
    }
}

std::span<const Figure> treeFigures(TreeColumns column) {
    static const FiguresWithTrees evergreen(shadowFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(shadowFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

}  // namespace noonmark
