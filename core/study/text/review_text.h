#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/study/provenance/repeat_review.h"
#include "core/study/review_study.h"

namespace noonmark {

/// How uncertain the figures of a review are, for files and sheets: some sentences.
std::string describeReviewErrors(const ReviewStudy& study);

/// The review as JSON; docs/rules.md lists the keys. Scripts rely on `rule`, `from`, `to`, `places` (`name`,
/// `kind`, `verdict`, `rows` of `day`, `enters`, `exits`, `duration_min`, `max_area_m2`, `max_point_min`,
/// `full_cover_min`) and `not_checked`.
nlohmann::ordered_json reviewJson(const ReviewStudy& study, const ReviewLabels& labels);

/// One line for each place and day: place, kind, verdict, the keys of a row, and the criteria.
std::string reviewCsv(const ReviewStudy& study, const ReviewLabels& labels);

}  // namespace noonmark
