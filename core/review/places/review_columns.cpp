#include "core/review/places/review_columns.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/describe/text.h"

namespace noonmark {

namespace {

void addRow(const ReviewRow& row, SeasonSum& sum) {
    sum.days += row.weight;
    if (row.durationMin <= 0) return;
    sum.daysWithShadow += row.weight;
    sum.incrementalM2h += row.weight * row.incrementalM2h;
    sum.longestMin = std::max(sum.longestMin, row.durationMin);
    sum.maxAreaM2 = std::max(sum.maxAreaM2, row.maxAreaM2);
    // Times of a clock have two digits for the hour, so texts are in the order of times.
    if (row.entersText.empty()) return;  // shadow between the centres of cells alone has no times
    if (sum.earliest.empty() || row.entersText < sum.earliest) sum.earliest = row.entersText;
    sum.latest = std::max(sum.latest, row.exitsText);
}

}  // namespace

std::array<SeasonSum, 4> sumSeasons(const PlaceReview& review) {
    std::array<SeasonSum, 4> seasons{SeasonSum{NM_TEXT("December to February")},
                                     SeasonSum{NM_TEXT("March to May")}, SeasonSum{NM_TEXT("June to August")},
                                     SeasonSum{NM_TEXT("September to November")}};
    for (const ReviewRow& row : review.rows) addRow(row, seasons[unsigned(row.day.month()) % 12 / 3]);
    return seasons;
}

namespace {

constexpr double ft2PerM2 = 1 / squareMetresPerSquareFoot;
constexpr std::string_view criterionPrefix = "criterion.";

std::string minutesText(double minutes) { return fmt::format("{:.10g}", std::round(minutes * 100) / 100); }
// Whole from a hundred on: a cell is about a square metre.
std::string areaText(double area) {
    std::string text = formatNumber(area, std::abs(area) < 100 ? 1 : 0);
    return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}
std::string percentText(double share) { return fmt::format("{:.1f} %", share * 100); }
std::string orDash(const std::string& text) { return text.empty() ? "-" : text; }

std::string hoursMinutes(double minutes) {
    const long whole = std::lround(minutes);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

struct Column {
    std::string key;
    std::function<std::string(const PlaceReview&, const ReviewRow&)> text;
};

using R = ReviewRow;
using P = PlaceReview;

double shareOf(const P& review, double m2h) {
    return review.totals.theoreticalM2h > 0 ? m2h / review.totals.theoreticalM2h : 0;
}

std::string figureText(const Figure& figure, double value) {
    switch (figure.unit) {
        case FigureUnit::minutes:
            return minutesText(value);
        case FigureUnit::share:
            return percentText(value);
        case FigureUnit::none:
            return fmt::format("{:.0f}", value);
        default:
            return areaText(value);
    }
}

/// "max_area_ft2" of "max_area_m2"; empty for other keys.
std::string imperialKey(std::string_view key) {
    const auto at = key.rfind("_m2");
    if (at == std::string_view::npos || key.starts_with(criterionPrefix)) return {};
    const std::string_view rest = key.substr(at + 3);
    if (!rest.empty() && rest != "h") return {};
    return fmt::format("{}_ft2{}", key.substr(0, at), rest);
}

void addFigureColumns(std::vector<Column>& columns, const Figure& figure) {
    const std::string key(figure.key);
    columns.push_back({key, [&figure](const P&, const R& r) { return figureText(figure, figure.get(&r)); }});
    if (figure.unit == FigureUnit::minutes)
        columns.push_back({key.substr(0, key.rfind("_min")) + "_hm",
                           [&figure](const P&, const R& r) { return hoursMinutes(figure.get(&r)); }});
    if (const std::string imperial = imperialKey(key); !imperial.empty())
        columns.push_back(
            {imperial, [&figure](const P&, const R& r) { return areaText(figure.get(&r) * ft2PerM2); }});
}

const std::vector<Column>& listColumns() {
    static const std::vector<Column> all = [] {
        std::vector<Column> columns{{"place", [](const P& p, const R&) { return p.name; }},
                                    {"day", [](const P&, const R& r) { return formatText(r.day); }},
                                    {"enters", [](const P&, const R& r) { return orDash(r.entersText); }},
                                    {"exits", [](const P&, const R& r) { return orDash(r.exitsText); }},
                                    {"max_at", [](const P&, const R& r) { return orDash(r.maxAtText); }},
                                    {"incremental_share", [](const P& p, const R& r) {
                                         return fmt::format("{:.4f} %", 100 * shareOf(p, r.incrementalM2h));
                                     }}};
        for (const Figure& figure : reviewRowFigures().rows()) addFigureColumns(columns, figure);
        return columns;
    }();
    return all;
}

/// "Largest area, sq ft" of "Largest area, m2"; a title without its unit gets one.
std::string imperialTitle(const RuleColumn& column) {
    for (const std::string_view metric : {"m2", "m²"})
        if (const auto at = column.title.rfind(metric); at != std::string::npos)
            return fmt::format("{}sq ft{}", column.title.substr(0, at),
                               column.title.substr(at + metric.size()));
    return fmt::format("{}, sq ft{}", column.title, column.key.ends_with("h") ? " h" : "");
}

std::string criterionText(const PlaceReview& review, const ReviewRow& row, std::string_view key) {
    for (std::size_t i = 0; i < review.criteria.size() && i < row.criteria.size(); ++i) {
        if (review.criteria[i].key != key || !row.criteria[i]) continue;
        const Measure measure = review.criteria[i].measure;
        if (measure == Measure::share || measure == Measure::largestShare)
            return percentText(*row.criteria[i]);
        return areaText(*row.criteria[i]);
    }
    return "-";
}

}  // namespace

const Figures<ReviewRow>& reviewRowFigures() {
    constexpr auto row = [](auto member, FigureFacts facts) {
        facts.jsonDecimals = 4;
        return figure(member, facts);
    };
    static const Figures<ReviewRow> figures{
        row(&R::durationMin, {.key = "duration_min",
                              .label = "Duration",
                              .definition = "minutes with incremental shadow anywhere on the place",
                              .decimals = 2,
                              .unit = FigureUnit::minutes,
                              .inTable = true}),
        row(&R::maxAreaM2, {.key = "max_area_m2",
                            .label = "Largest area",
                            .definition = "largest incremental shadow at one step",
                            .decimals = 1,
                            .unit = FigureUnit::squareMetres,
                            .inTable = true}),
        row(&R::maxPointMin, {.key = "max_point_min",
                              .label = "Most at one spot",
                              .definition = "most minutes of incremental shadow at one spot",
                              .decimals = 2,
                              .unit = FigureUnit::minutes,
                              .inTable = true}),
        row(&R::fullCoverMin, {.key = "full_cover_min",
                               .label = "All sun taken",
                               .definition = "minutes in which all sun that the baseline leaves is gone",
                               .decimals = 2,
                               .unit = FigureUnit::minutes,
                               .inTable = true}),
        row(&R::intervals, {.key = "intervals",
                            .label = "Intervals",
                            .definition = "unbroken intervals of incremental shadow",
                            .decimals = 0,
                            .unit = FigureUnit::none,
                            .inTable = true}),
        row(&R::maxShare, {.key = "max_share",
                           .label = "Largest share",
                           .definition = "largest incremental shadow at one step, of the area",
                           .decimals = 4,
                           .unit = FigureUnit::share}),
        row(&R::maxPointRunMin, {.key = "max_point_run_min",
                                 .label = "Longest at one spot",
                                 .definition = "longest unbroken incremental shadow at one spot",
                                 .decimals = 2,
                                 .unit = FigureUnit::minutes}),
        row(&R::totalDurationMin, {.key = "total_duration_min",
                                   .label = "Duration of all shadow",
                                   .definition = "minutes with any shadow on the place",
                                   .decimals = 2,
                                   .unit = FigureUnit::minutes}),
        row(&R::totalMaxAreaM2, {.key = "total_max_area_m2",
                                 .label = "Largest area of all shadow",
                                 .definition = "largest shadow at one step",
                                 .decimals = 1,
                                 .unit = FigureUnit::squareMetres}),
        row(&R::totalMaxPointMin, {.key = "total_max_point_min",
                                   .label = "Most of all shadow at one spot",
                                   .definition = "most minutes of shadow at one spot",
                                   .decimals = 2,
                                   .unit = FigureUnit::minutes}),
        row(&R::minSunMin, {.key = "least_sun_min",
                            .label = "Least sun",
                            .definition = "minutes of sun of the spot with the least of it",
                            .decimals = 2,
                            .unit = FigureUnit::minutes}),
        row(&R::minSunRunMin, {.key = "least_sun_run_min",
                               .label = "Its longest sun",
                               .definition = "longest unbroken sun of the spot with the least sun",
                               .decimals = 2,
                               .unit = FigureUnit::minutes}),
        row(&R::minLongestSunMin, {.key = "least_longest_sun_min",
                                   .label = "Shortest longest sun",
                                   .definition = "longest unbroken sun of the spot where it is shortest",
                                   .decimals = 2,
                                   .unit = FigureUnit::minutes}),
        row(&R::minSunIntervals, {.key = "least_sun_intervals",
                                  .label = "Its intervals",
                                  .definition = "intervals of sun of the spot with the least sun",
                                  .decimals = 0,
                                  .unit = FigureUnit::none}),
        row(&R::baselineM2h, {.key = "baseline_m2h",
                              .label = "Baseline",
                              .definition = "area x hours in shadow in the baseline",
                              .decimals = 1,
                              .unit = FigureUnit::squareMetreHours,
                              .inTable = true}),
        row(&R::scenarioM2h, {.key = "scenario_m2h",
                              .label = "Scenario",
                              .definition = "area x hours in shadow in the scenario",
                              .decimals = 1,
                              .unit = FigureUnit::squareMetreHours,
                              .inTable = true}),
        row(&R::incrementalM2h, {.key = "incremental_m2h",
                                 .label = "Incremental",
                                 .definition = "area x hours in shadow in the scenario, lit in the baseline",
                                 .decimals = 1,
                                 .unit = FigureUnit::squareMetreHours,
                                 .inTable = true}),
        row(&R::gainedM2h, {.key = "gained_m2h",
                            .label = "Gained",
                            .definition = "area x hours lit in the scenario, in shadow in the baseline",
                            .decimals = 1,
                            .unit = FigureUnit::squareMetreHours,
                            .inTable = true}),
        row(&R::hoursMin, {.key = "window_min",
                           .label = "Sunlit time",
                           .definition = "minutes with the sun up in the hours of the rule",
                           .decimals = 2,
                           .unit = FigureUnit::minutes}),
    };
    return figures;
}

std::vector<std::string_view> reviewColumnKeys() {
    std::vector<std::string_view> keys;
    for (const Column& column : listColumns()) keys.push_back(column.key);
    return keys;
}

bool isReviewColumn(const Rule& rule, std::string_view key) {
    if (!key.starts_with(criterionPrefix))
        return std::ranges::find(listColumns(), key, &Column::key) != listColumns().end();
    return std::ranges::find(rule.criteria, key.substr(criterionPrefix.size()), &Criterion::key) !=
           rule.criteria.end();
}

std::vector<RuleColumn> columnsIn(UnitSystem units, const std::vector<RuleColumn>& columns) {
    if (units == UnitSystem::metric) return columns;
    std::vector<RuleColumn> shown;
    for (const RuleColumn& column : columns) {
        const std::string key = imperialKey(column.key);
        if (key.empty() || units == UnitSystem::both) shown.push_back(column);
        if (!key.empty() && std::ranges::find(columns, key, &RuleColumn::key) == columns.end())
            shown.push_back({imperialTitle(column), key});
    }
    return shown;
}

std::string columnText(const PlaceReview& review, const ReviewRow& row, std::string_view key) {
    if (key.starts_with(criterionPrefix))
        return criterionText(review, row, key.substr(criterionPrefix.size()));
    const auto found = std::ranges::find(listColumns(), key, &Column::key);
    return found == listColumns().end() ? "-" : found->text(review, row);
}

}  // namespace noonmark
