#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/review/criteria/criterion_days.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/review_study.h"

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

/// How uncertain the figures of a review are, for files and sheets: some sentences.
std::string describeReviewErrors(const ReviewStudy& study);

/// The review as JSON; docs/rules.md lists the keys. Scripts rely on `rule`, `from`, `to`, `places` (`name`,
/// `kind`, `verdict`, `rows` of `day`, `enters`, `exits`, `duration_min`, `max_area_m2`, `max_point_min`,
/// `full_cover_min`) and `not_checked`.
nlohmann::ordered_json reviewJson(const ReviewStudy& study, const ReviewLabels& labels);

/// One line for each place and day: place, kind, verdict, the keys of a row, and the criteria.
std::string reviewCsv(const ReviewStudy& study, const ReviewLabels& labels);

}  // namespace noonmark
