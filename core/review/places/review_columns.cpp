#include "core/review/places/review_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace noonmark {

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
    std::string_view key;
    std::string (*text)(const PlaceReview&, const ReviewRow&);
};

using R = ReviewRow;
using P = PlaceReview;

double shareOf(const P& review, double m2h) {
    return review.totals.theoreticalM2h > 0 ? m2h / review.totals.theoreticalM2h : 0;
}

const std::array columns{
    Column{"place", [](const P& p, const R&) { return p.name; }},
    Column{"day", [](const P&, const R& r) { return formatText(r.day); }},
    Column{"enters", [](const P&, const R& r) { return orDash(r.entersText); }},
    Column{"exits", [](const P&, const R& r) { return orDash(r.exitsText); }},
    Column{"duration_min", [](const P&, const R& r) { return minutesText(r.durationMin); }},
    Column{"duration_hm", [](const P&, const R& r) { return hoursMinutes(r.durationMin); }},
    Column{"intervals", [](const P&, const R& r) { return fmt::to_string(r.intervals); }},
    Column{"max_area_m2", [](const P&, const R& r) { return areaText(r.maxAreaM2); }},
    Column{"max_area_ft2", [](const P&, const R& r) { return areaText(r.maxAreaM2 * ft2PerM2); }},
    Column{"max_share", [](const P&, const R& r) { return percentText(r.maxShare); }},
    Column{"max_at", [](const P&, const R& r) { return orDash(r.maxAtText); }},
    Column{"max_point_min", [](const P&, const R& r) { return minutesText(r.maxPointMin); }},
    Column{"max_point_hm", [](const P&, const R& r) { return hoursMinutes(r.maxPointMin); }},
    Column{"max_point_run_min", [](const P&, const R& r) { return minutesText(r.maxPointRunMin); }},
    Column{"full_cover_min", [](const P&, const R& r) { return minutesText(r.fullCoverMin); }},
    Column{"total_duration_min", [](const P&, const R& r) { return minutesText(r.totalDurationMin); }},
    Column{"total_max_area_m2", [](const P&, const R& r) { return areaText(r.totalMaxAreaM2); }},
    Column{"total_max_area_ft2", [](const P&, const R& r) { return areaText(r.totalMaxAreaM2 * ft2PerM2); }},
    Column{"total_max_point_min", [](const P&, const R& r) { return minutesText(r.totalMaxPointMin); }},
    Column{"least_sun_min", [](const P&, const R& r) { return minutesText(r.leastSunMin); }},
    Column{"least_sun_hm", [](const P&, const R& r) { return hoursMinutes(r.leastSunMin); }},
    Column{"least_sun_run_min", [](const P&, const R& r) { return minutesText(r.leastSunRunMin); }},
    Column{"least_longest_sun_min", [](const P&, const R& r) { return minutesText(r.leastLongestSunMin); }},
    Column{"least_sun_intervals", [](const P&, const R& r) { return fmt::to_string(r.leastSunIntervals); }},
    Column{"baseline_m2h", [](const P&, const R& r) { return areaText(r.baselineM2h); }},
    Column{"scenario_m2h", [](const P&, const R& r) { return areaText(r.scenarioM2h); }},
    Column{"incremental_m2h", [](const P&, const R& r) { return areaText(r.incrementalM2h); }},
    Column{"gained_m2h", [](const P&, const R& r) { return areaText(r.gainedM2h); }},
    Column{"baseline_ft2h", [](const P&, const R& r) { return areaText(r.baselineM2h * ft2PerM2); }},
    Column{"scenario_ft2h", [](const P&, const R& r) { return areaText(r.scenarioM2h * ft2PerM2); }},
    Column{"incremental_ft2h", [](const P&, const R& r) { return areaText(r.incrementalM2h * ft2PerM2); }},
    Column{"gained_ft2h", [](const P&, const R& r) { return areaText(r.gainedM2h * ft2PerM2); }},
    Column{
        "incremental_share",
        [](const P& p, const R& r) { return fmt::format("{:.4f} %", 100 * shareOf(p, r.incrementalM2h)); }},
    Column{"window_min", [](const P&, const R& r) { return minutesText(r.windowMin); }},
};

/// "max_area_ft2" of "max_area_m2"; empty for other keys.
std::string imperialKey(std::string_view key) {
    const auto at = key.rfind("_m2");
    if (at == std::string_view::npos || key.starts_with(criterionPrefix)) return {};
    const std::string_view rest = key.substr(at + 3);
    if (!rest.empty() && rest != "h") return {};
    return fmt::format("{}_ft2{}", key.substr(0, at), rest);
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

std::vector<std::string_view> reviewColumnKeys() {
    std::vector<std::string_view> keys;
    for (const Column& column : columns) keys.push_back(column.key);
    return keys;
}

bool isReviewColumn(const Rule& rule, std::string_view key) {
    if (!key.starts_with(criterionPrefix))
        return std::ranges::find(columns, key, &Column::key) != columns.end();
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
    const auto found = std::ranges::find(columns, key, &Column::key);
    return found == columns.end() ? "-" : found->text(review, row);
}

}  // namespace noonmark
