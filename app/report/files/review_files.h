#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "core/io/files/check_output.h"
#include "core/study/text/review_text.h"

namespace noonmark {

/// The files of a review: review.json, review.csv and sheets.pdf.
std::vector<std::string> reviewFileNames();

/// Writes the files of a review into a folder, which is created if missing; all or none. `rules`: which files
/// may be replaced. Returns the paths written. Needs a QGuiApplication.
Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewStudy& study,
                                                            const ReviewLabels& labels, const Book& sheets,
                                                            const std::filesystem::path& folder,
                                                            const OutputRules& rules = {});

}  // namespace noonmark
