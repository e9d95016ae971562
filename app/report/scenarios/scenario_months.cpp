#include "app/report/scenarios/scenario_months.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/csv_text.h"
#include "core/describe/figure_text.h"
#include "core/describe/text.h"
#include "core/study/text/breakdown_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Month = std::chrono::year_month;
using ByMonth = std::map<Month, double>;

Month monthOf(const Bars::Group& group) { return std::get<Month>(group.name); }

ByMonth sunOf(const ScenarioMonths& scenario) {
    ByMonth hours;
    if (!scenario.study) return hours;
    for (const Bars::Group& group : makeMonthBars(*scenario.study).groups)
        hours[monthOf(group)] = group.values.front();
    return hours;
}

ByMonth sunOfPlaces(const ScenarioMonths& scenario) {
    ByMonth hours;
    if (!scenario.sun) return hours;
    const std::vector<double>& values = scenario.sun->mean.monthHours;
    for (std::size_t i = 0; i < values.size(); ++i) hours[monthOfKey(scenario.sun->months[i])] = values[i];
    return hours;
}

ByMonth scoreOf(const ScenarioMonths& scenario, double MonthFigures::*figure) {
    ByMonth values;
    for (const MonthFigures& month : scenario.score) values[month.month] = month.*figure;
    return values;
}

// A score counts it, too.
ByMonth areaOf(const ScenarioMonths& scenario) {
    ByMonth areas = scoreOf(scenario, &MonthFigures::shadowAreaM2);
    if (!scenario.study) return areas;
    const Bars bars = makeMonthBars(*scenario.study);
    if (bars.groups.empty()) return areas;
    const std::vector<MonthShadow> months = monthsOf(*scenario.study->breakdown);
    for (std::size_t i = 0; i < bars.groups.size(); ++i)
        areas[monthOf(bars.groups[i])] = months[i].shadowAreaM2;
    return areas;
}

ByMonth weightedOf(const ScenarioMonths& scenario) {
    return scoreOf(scenario, &MonthFigures::weightedShadeM2h);
}

ByMonth pointsOf(const ScenarioMonths& scenario) { return scoreOf(scenario, &MonthFigures::scoreM2); }

struct MonthlyFigure {
    std::string_view key;
    FigureUnit unit;
    int decimals;
    std::string_view title, changeTitle;
    ByMonth (*valuesOf)(const ScenarioMonths&);
    std::string_view definition;
    MonthsOf of = MonthsOf::study;
};

const std::array<MonthlyFigure, 5>& monthlyFigures() {
    const auto definitionOf = [](std::string_view key) {
        return findFigure(scoreMonthFigures().rows(), key).definition;
    };
    static const std::array<MonthlyFigure, 5> figures{
        {{"sun_hours", FigureUnit::none, 4, NM_TEXT("Hours of sun a day by month"),
          NM_TEXT("Change of the hours of sun a day by month"), sunOf,
          "hours of sun a day, mean over the month's days and the receivers"},
         {"places_sun_hours", FigureUnit::none, 4, NM_TEXT("Hours of sun a day in the places by month"),
          NM_TEXT("Change of the hours of sun a day in the places by month"), sunOfPlaces,
          "hours of sun a day, mean over the month's days and the area of the places that were measured",
          MonthsOf::places},
         {"shadow_area_m2", FigureUnit::squareMetres, 1, NM_TEXT("Shadow area by month, m²"),
          NM_TEXT("Change of the shadow area by month, m²"), areaOf, definitionOf("shadow_area_m2")},
         {"weighted_shade_m2h", FigureUnit::squareMetreHours, 1, NM_TEXT("Weighted shade by month, m² h"),
          NM_TEXT("Change of the weighted shade by month, m² h"), weightedOf,
          definitionOf("weighted_shade_m2h"), MonthsOf::score},
         {"score_m2", FigureUnit::squareMetres, 1, NM_TEXT("Shadow score by month, m²"),
          NM_TEXT("Change of the shadow score by month, m²"), pointsOf, definitionOf("score_m2"),
          MonthsOf::score}}};
    return figures;
}

MonthChart chartOf(const MonthlyFigure& figure, std::span<const ScenarioMonths> scenarios) {
    MonthChart chart{figure.key, figure.unit, figure.decimals, {.title = figure.title, .series = {}}, {}};
    std::vector<ByMonth> all;
    std::set<Month> months;
    for (const ScenarioMonths& scenario : scenarios) {
        const ByMonth values = figure.valuesOf(scenario);
        if (values.empty()) continue;
        chart.values.series.push_back(scenario.name);
        for (const auto& [month, value] : values) months.insert(month);
        all.push_back(values);
    }
    for (const Month month : months) {
        Bars::Group& group = chart.values.groups.emplace_back(Bars::Group{month, {}});
        for (const ByMonth& values : all) {
            const auto found = values.find(month);
            group.values.push_back(found == values.end() ? none : found->second);
        }
    }
    if (!all.empty() && chart.values.series.front() == scenarios.front().name)
        chart.changes = changesOf(chart.values, figure.changeTitle);
    return chart;
}

// NaN: the scenario has no bar there.
double valueIn(const Bars& bars, const std::string& scenario, Month month) {
    const auto series = std::ranges::find(bars.series, scenario);
    const auto group = std::ranges::find(bars.groups, month, monthOf);
    if (series == bars.series.end() || group == bars.groups.end()) return none;
    return group->values[std::size_t(series - bars.series.begin())];
}

std::set<Month> monthsOf(const std::vector<MonthChart>& charts) {
    std::set<Month> months;
    for (const MonthChart& chart : charts)
        for (const Bars::Group& group : chart.values.groups) months.insert(monthOf(group));
    return months;
}

std::vector<std::string> scenariosOf(const std::vector<MonthChart>& charts) {
    std::vector<std::string> names;
    for (const MonthChart& chart : charts)
        for (const std::string& name : chart.values.series)
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

// "shadow_area_change_m2" of "shadow_area_m2".
std::string changeKey(const MonthChart& chart) {
    std::string key(chart.key);
    return key.insert(key.rfind('_'), "_change");
}

}  // namespace

std::vector<ScenarioMonths> listMonths(const ScenarioStudies& scenarios) {
    std::vector<ScenarioMonths> months;
    for (const ScenarioStudy& scenario : scenarios) {
        months.push_back({scenario.name, scenario.study});
        if (scenario.answers.score) months.back().score = scenario.answers.score->months;
    }
    return months;
}

std::vector<MonthChartName> monthChartNames() {
    std::vector<MonthChartName> names;
    for (const MonthlyFigure& figure : monthlyFigures())
        names.push_back({figure.key, figure.title, figure.of});
    return names;
}

std::vector<MonthChart> makeMonthCharts(std::span<const ScenarioMonths> scenarios) {
    std::vector<MonthChart> charts;
    for (const MonthlyFigure& figure : monthlyFigures())
        if (MonthChart chart = chartOf(figure, scenarios); !chart.values.groups.empty())
            charts.push_back(std::move(chart));
    return charts;
}

std::string monthsCsv(const std::vector<MonthChart>& charts) {
    std::vector<std::string> columns{"scenario", "month"};
    for (const MonthChart& chart : charts)
        columns.insert(columns.end(), {std::string(chart.key), changeKey(chart)});
    CsvText csv(columns);
    for (const std::string& scenario : scenariosOf(charts))
        for (const Month month : monthsOf(charts)) {
            csv.text(scenario).text(groupKey({month}));
            for (const MonthChart& chart : charts)
                for (const Bars* bars : {&chart.values, &chart.changes})
                    csv.number(valueIn(*bars, scenario, month), chart.decimals);
            csv.endRow();
        }
    return csv.take();
}

Json monthsJson(const std::vector<MonthChart>& charts, const std::string& scenario) {
    const auto orNull = [](double value) { return std::isnan(value) ? Json() : Json(value); };
    Json json = Json::array();
    for (const Month month : monthsOf(charts)) {
        Json& object = json.emplace_back(Json{{"month", groupKey({month})}});
        for (const MonthChart& chart : charts) {
            object[chart.key] = orNull(valueIn(chart.values, scenario, month));
            object[changeKey(chart)] = orNull(valueIn(chart.changes, scenario, month));
        }
    }
    return json;
}

Json definitionsJson(const std::vector<MonthChart>& charts) {
    Json json = Json::object();
    for (const MonthlyFigure& figure : monthlyFigures())
        if (std::ranges::find(charts, figure.key, &MonthChart::key) != charts.end())
            json[figure.key] = figure.definition;
    return json;
}

}  // namespace noonmark
