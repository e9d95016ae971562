#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "app/report/scenarios/scenario_study.h"
#include "core/describe/answer_page.h"
#include "core/describe/figure.h"

namespace noonmark {

/// What is known of the months of a scenario.
struct ScenarioMonths {
    std::string name;
    std::shared_ptr<const Study> study{};  ///< null: none; it may have no months
    std::vector<MonthFigures> score{};     ///< empty: not scored
    std::optional<ScenarioSun> sun{};      ///< of places; none: not measured
};
std::vector<ScenarioMonths> listMonths(const ScenarioStudies& scenarios);

/// A figure of the months of several scenarios side by side.
struct MonthChart {
    std::string_view key;  ///< of CSV and JSON, with its unit: "sun_hours"
    FigureUnit unit = FigureUnit::none;
    int decimals = 1;
    Bars values;   ///< a series for each scenario that has the figure
    Bars changes;  ///< from the first scenario; without groups where it or all others lack the figure
};

/// What has to be measured for a chart of months.
enum class MonthsOf { study, places, score };

/// Which charts there may be.
struct MonthChartName {
    std::string_view key, title;  ///< the title is NM_TEXT
    MonthsOf of = MonthsOf::study;
};
std::vector<MonthChartName> monthChartNames();

/// Hours of sun, those of places, shadow area, weighted shade and score by month: those that any scenario
/// has. Costs some milliseconds for each million cells of a study.
std::vector<MonthChart> makeMonthCharts(std::span<const ScenarioMonths> scenarios);

/// Columns: scenario,month, and for each chart its key and that of its change
/// ("shadow_area_m2", "shadow_area_change_m2"). RFC 4180; fields are empty where a
/// scenario lacks the figure.
std::string monthsCsv(const std::vector<MonthChart>& charts);

/// The same of one scenario: an object for each month; what it lacks is null.
nlohmann::ordered_json monthsJson(const std::vector<MonthChart>& charts, const std::string& scenario);

/// Definitions of the charts' keys.
nlohmann::ordered_json definitionsJson(const std::vector<MonthChart>& charts);

}  // namespace noonmark
