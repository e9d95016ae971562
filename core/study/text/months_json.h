#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/study/text/breakdown_text.h"

namespace noonmark {

/// One object for each month: month, sunlit_min, shadow_area_m2, mean_shadow_min.
nlohmann::ordered_json monthsJson(const std::vector<MonthShadow>& months);

}  // namespace noonmark
