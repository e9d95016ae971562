#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/window/review/review_question.h"
#include "core/io/files/check_output.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

/// What the files of a review are made from, besides its answer.
struct ReviewExport {
    std::shared_ptr<const ReviewAnswer> answer;
    Project project;
    std::optional<ProjectFile> file;  ///< none: the project was never saved
    Warnings ofRules;                 ///< of reading the library of rules
    OutputRules outputs;              ///< which files may be replaced
};

/// Computes the review again with its timelines, and writes the files of `noonmark-cli review run`. Errors as
/// of writeReviewFiles(). Returns the paths written.
Result<std::vector<std::filesystem::path>> exportReview(const ReviewExport& review,
                                                        const std::filesystem::path& folder,
                                                        Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
