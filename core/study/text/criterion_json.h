#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "core/review/criteria/criterion_days.h"

namespace noonmark {

// Parts that reviews of places and of windows share.

double round4(double value);                        ///< to four digits after the point
nlohmann::ordered_json numberOrNull(double value);  ///< the same; null if it is not finite
/// `value` and the range `low` to `high`; null without a value.
nlohmann::ordered_json measuredJson(const std::optional<Measured>& measured);
/// A criterion with its limits and what it found.
nlohmann::ordered_json criterionJson(const Criterion& criterion, const CriterionResult& result);
/// What a review says of its rule: name, chosen options, status, readings, and figures with their sources.
nlohmann::ordered_json ruleJson(const Rule& rule);

}  // namespace noonmark
