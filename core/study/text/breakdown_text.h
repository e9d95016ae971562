#pragma once

#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// A month's figures over the region.
struct MonthShadow {
    std::string month;  ///< "2026-01"
    double sunlitMinutes = 0;
    double shadowAreaM2 = 0;  ///< share of the month's sunlit time x area
    double meanMinutes = 0;   ///< in shadow in the whole month, mean over the receivers
};
std::vector<MonthShadow> monthsOf(const ShadowBreakdown& breakdown);

/// month,sunlit_min,shadow_area_m2,mean_shadow_min and what it is of (source_columns.h): a line a set of the
/// study's breakdown, which must be there.
std::string monthsCsv(const Study& study);

/// building,source_id,name,attributed_min_m2,sole_min_m2: a line for each building that shades a receiver,
/// the largest first; with several months two more columns for each of them ("attributed 2026-01", "sole
/// 2026-01"), and last what it is of. The study's breakdown must be there.
std::string contributionsCsv(const Study& study);

}  // namespace noonmark
