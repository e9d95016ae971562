#include "core/study/text/breakdown_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/base/csv_text.h"
#include "core/describe/figure_text.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/provenance_texts.h"

namespace noonmark {

namespace {

constexpr std::string_view monthTitle = NM_TEXT("Hours of sun a day by month");

struct MonthDays {
    std::chrono::year_month month;
    double days = 0;  // of the period, with those on which the sun does not rise
};

std::vector<MonthDays> countDays(CivilDate start, int days) {
    std::vector<MonthDays> months;
    for (int day = 0; day < days; ++day) {
        const CivilDate date = std::chrono::sys_days(start) + std::chrono::days(day);
        const std::chrono::year_month month{date.year(), date.month()};
        if (months.empty() || months.back().month != month) months.push_back({month});
        ++months.back().days;
    }
    return months;
}

}  // namespace

double sumOf(const std::vector<float>& minutes) {
    double sum = 0;
    for (const float value : minutes)
        if (!std::isnan(value)) sum += double(value);
    return sum;
}

double sumOf(const std::vector<double>& minM2) { return std::accumulate(minM2.begin(), minM2.end(), 0.0); }

std::vector<BuildingShadow> sortContributions(const ShadowBreakdown& breakdown) {
    std::vector<BuildingShadow> shadows = breakdown.buildings;
    std::ranges::stable_sort(shadows, std::ranges::greater{},
                             [](const BuildingShadow& shadow) { return sumOf(shadow.attributedMinM2); });
    return shadows;
}

std::vector<MonthShadow> monthsFromSums(const StepSets& sets, const std::vector<double>& sunlitMinutes,
                                        const std::vector<double>& minutes, std::size_t receivers,
                                        double cellAreaM2) {
    std::vector<MonthShadow> months;
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        const double sunlit = sunlitMinutes.at(set), sum = minutes.at(set);
        months.push_back({sets.names[set], sunlit, sunlit > 0 ? sum / sunlit * cellAreaM2 : 0,
                          receivers > 0 ? sum / double(receivers) : 0});
    }
    return months;
}

std::vector<MonthShadow> monthsOf(const ShadowBreakdown& breakdown) {
    if (breakdown.minutes.empty()) return {};
    std::vector<double> sums;
    for (const std::vector<float>& minutes : breakdown.minutes) sums.push_back(sumOf(minutes));
    return monthsFromSums(breakdown.sets, breakdown.sunlitMinutes, sums, breakdown.cells.size(),
                          breakdown.grid.cellAreaM2());
}

Bars makeMonthBars(const std::vector<MonthShadow>& months, CivilDate start, int days) {
    Bars bars{.title = monthTitle};
    const std::vector<MonthDays> counted =
        countDays(start, days);  // as many as sets (monthsOf in step_sets.h)
    for (std::size_t i = 0; i < std::min(counted.size(), months.size()); ++i) {
        const double sunMin = months[i].sunlitMinutes - months[i].meanMinutes;
        bars.groups.push_back({counted[i].month, {sunMin / minutesPerHour / counted[i].days}, BarTone::sun});
    }
    return bars;
}

Bars makeMonthBars(const ShadowBreakdown& breakdown, const SunSteps& sun) {
    if (sun.days.empty()) return {.title = monthTitle};
    return makeMonthBars(monthsOf(breakdown), sun.days.front().date, int(sun.days.size()));
}

Bars makeMonthBars(const Study& study) {
    if (!study.settings.byMonth || !study.breakdown) return {.title = monthTitle};
    return makeMonthBars(*study.breakdown, study.sun);
}

Bars makeMonthBarsWithTrees(const Study& study) {
    Bars bars = makeMonthBars(study);
    const std::vector<MonthsWithTrees> columns = listMonthsWithTrees(study);
    if (bars.groups.empty() || columns.empty()) return bars;
    bars.series = {"without trees"};
    for (const MonthsWithTrees& with : columns) {
        bars.series.emplace_back(describeTrees(with.column));
        const Bars own = makeMonthBars(with.months, study.sun.days.front().date, int(study.sun.days.size()));
        for (std::size_t i = 0; i < bars.groups.size(); ++i)
            bars.groups[i].values.push_back(own.groups.at(i).values.front());
    }
    return bars;
}

AnswerPage withMonths(AnswerPage page, Bars months) {
    if (!months.groups.empty()) page.charts.insert(page.charts.begin(), std::move(months));
    return page;
}

const Figures<MonthShadow>& monthFigures() {
    static const Figures<MonthShadow> figures{
        figure(&MonthShadow::sunlitMinutes,
               {.key = "sunlit_min",
                .label = NM_TEXT("Sunlit time"),
                .definition = NM_TEXT("minutes of the month with the sun above the horizon"),
                .unit = FigureUnit::minutes,
                .use = FigureUse::basis}),
        figure(&MonthShadow::shadowAreaM2,
               {.key = "shadow_area_m2",
                .label = NM_TEXT("Shadow area"),
                .definition =
                    NM_TEXT("sum over the receivers of (share of the sunlit time in shadow x cell area)"),
                .decimals = 2,
                .unit = FigureUnit::squareMetres,
                .whole = Whole::area}),
        figure(&MonthShadow::meanMinutes,
               {.key = "mean_shadow_min",
                .label = NM_TEXT("Mean shadow"),
                .definition = NM_TEXT("minutes in shadow in the whole month, mean over the receivers"),
                .decimals = 2,
                .unit = FigureUnit::minutes})};
    return figures;
}

std::span<const Figure> monthFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(monthFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(monthFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::vector<MonthsWithTrees> listMonthsWithTrees(const Study& study) {
    std::vector<MonthsWithTrees> all;
    if (!study.shadedMonths) return all;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (const auto& breakdown = study.shadedMonths->of(column))
            all.push_back({column, monthsOf(*breakdown)});
    return all;
}

nlohmann::ordered_json monthsJson(const std::vector<MonthShadow>& months,
                                  std::span<const MonthsWithTrees> withTrees) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < months.size(); ++i) {
        json.push_back({{"month", months[i].month}});
        json.back().update(figuresJson(monthFigures().of(months[i])));
        for (const MonthsWithTrees& with : withTrees)
            json.back().update(figuresJson({monthFiguresWithTrees(with.column), &with.months.at(i)}));
    }
    return json;
}

std::vector<MonthShadow> parseMonths(const nlohmann::ordered_json& json) {
    std::vector<MonthShadow> months;
    for (const auto& one : json) {
        months.push_back(readFigures(monthFigures(), one));
        months.back().month = one.at("month");
    }
    return months;
}

std::string monthsCsv(const std::vector<MonthShadow>& months, const Provenance& provenance,
                      std::span<const MonthsWithTrees> withTrees) {
    std::vector<std::string> columns = listColumns(monthFigures().rows());
    columns.insert(columns.begin(), "month");
    for (const MonthsWithTrees& with : withTrees)
        std::ranges::move(listColumns(monthFiguresWithTrees(with.column)), std::back_inserter(columns));
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(provenance);
    for (std::size_t i = 0; i < months.size(); ++i) {
        csv.text(months[i].month);
        addFigures(csv, monthFigures().of(months[i]));
        for (const MonthsWithTrees& with : withTrees)
            addFigures(csv, {monthFiguresWithTrees(with.column), &with.months.at(i)});
        addSource(csv, source);
        csv.endRow();
    }
    return csv.take();
}

std::string monthsCsv(const Study& study) {
    return monthsCsv(monthsOf(*study.breakdown), study.provenance, listMonthsWithTrees(study));
}

}  // namespace noonmark
