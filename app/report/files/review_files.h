#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "core/study/text/review_text.h"

namespace noonmark {

/// The files of a review: review.json and review.csv.
std::vector<std::string> reviewFileNames();

/// Writes the files of a review into a folder, which is created if missing; all or none. `rules`: which files
/// may be replaced. Returns the paths written.
Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewStudy& study,
                                                            const ReviewLabels& labels,
                                                            const std::filesystem::path& folder,
                                                            const OutputRules& rules = {});

}  // namespace noonmark
