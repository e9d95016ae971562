#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/study/study.h"

namespace noonmark {

/// The shadow of one month over the region.
struct MonthShadow {
    std::string month;  ///< "2026-01"
    double sunlitMinutes = 0;
    double shadowAreaM2 = 0;  ///< share of the month's sunlit time x area
    double meanMinutes = 0;   ///< minutes in shadow in the whole month, mean over the receivers
};
/// The figures of a month, without its name.
const Figures<MonthShadow>& monthFigures();
/// The same with trees of a column: "shadow_area_m2_evergreen".
std::span<const Figure> monthFiguresWithTrees(TreeColumns column);
std::vector<MonthShadow> monthsOf(const ShadowBreakdown& breakdown);

/// The months with trees of one column, in the order of those without.
struct MonthsWithTrees {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    std::vector<MonthShadow> months;
};
/// Evergreens first. None where the study has no months with trees.
std::vector<MonthsWithTrees> listMonthsWithTrees(const Study& study);

/// The same from the sums over all receivers of a study in tiles. `minutes`: one sum for each set.
std::vector<MonthShadow> monthsFromSums(const StepSets& sets, const std::vector<double>& sunlitMinutes,
                                        const std::vector<double>& minutes, std::size_t receivers,
                                        double cellAreaM2);

/// The sum of all values but NaN.
double sumOf(const std::vector<float>& minutes);

/// What a building does in all sets of steps together.
double sumOf(const std::vector<double>& minM2);
/// The breakdown's buildings, those with the most attributed shadow first.
std::vector<BuildingShadow> sortContributions(const ShadowBreakdown& breakdown);

/// Hours of sun a day, mean over the receivers, of each month of so many days from `start`. No groups: of a
/// study without months.
Bars makeMonthBars(const std::vector<MonthShadow>& months, CivilDate start, int days);
Bars makeMonthBars(const Study& study);
/// The same with a bar for each column of trees that the study has.
Bars makeMonthBarsWithTrees(const Study& study);
/// The bars of a breakdown by month of the period with this sun.
Bars makeMonthBars(const ShadowBreakdown& breakdown, const SunSteps& sun);
/// The page with these bars before its other charts; as it is where they have no groups.
AnswerPage withMonths(AnswerPage page, Bars months);

/// One object for each month: month, and its figures, then those with trees.
nlohmann::ordered_json monthsJson(const std::vector<MonthShadow>& months,
                                  std::span<const MonthsWithTrees> withTrees = {});
/// The inverse. Throws where the JSON has another shape.
std::vector<MonthShadow> parseMonths(const nlohmann::ordered_json& json);

/// Columns: month,sunlit_min,shadow_area_m2,mean_shadow_min, the latter two with trees, and the source
/// columns (provenance_texts.h); one row per set of the study's breakdown, which must exist.
std::string monthsCsv(const Study& study);
std::string monthsCsv(const std::vector<MonthShadow>& months, const Provenance& provenance,
                      std::span<const MonthsWithTrees> withTrees = {});

}  // namespace noonmark
