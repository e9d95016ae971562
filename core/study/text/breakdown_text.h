#pragma once

#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// The shadow of one month over the region.
struct MonthShadow {
    std::string month;  ///< "2026-01"
    double sunlitMinutes = 0;
    double shadowAreaM2 = 0;  ///< share of the month's sunlit time x area
    double meanMinutes = 0;   ///< minutes in shadow in the whole month, mean over the receivers
};
std::vector<MonthShadow> monthsOf(const ShadowBreakdown& breakdown);

/// Columns: month,sunlit_min,shadow_area_m2,mean_shadow_min and the source columns (source_columns.h); one
/// row per set of the study's breakdown, which must exist.
std::string monthsCsv(const Study& study);

/// Columns: building,source_id,name,attributed_min_m2,sole_min_m2; with several months two more columns for
/// each of them ("attributed 2026-01", "sole 2026-01"); then the source columns. One row for each building
/// that shades a receiver, the largest first. The study's breakdown must exist.
std::string contributionsCsv(const Study& study);

}  // namespace noonmark
