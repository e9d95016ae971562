#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/docks/review/review_question.h"
#include "app/report/book/review/review_book.h"
#include "core/io/files/check_output.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

/// What the sheets and files of a review are made from.
struct ReviewExport {
    std::shared_ptr<const ReviewAnswer> answer;
    Project project;
    std::optional<ProjectFile> file;  ///< none: the project was never saved
    Warnings ofRules;                 ///< of reading the library of rules
    OutputRules outputs;              ///< which files may be replaced
};

/// The review with its timelines, and its book, which refers to the rest: never changed once it is made.
struct ReviewSheets {
    BookSettings settings;
    ReviewLabels labels;
    std::shared_ptr<const ReviewStudy> study;
    Book book;
};

/// Lays the book of a review out. `study`: that of an earlier call for the same review, or null: the review
/// is computed again, with its timelines. Errors of runReview() and makeReviewBook(); cancelled().
Result<std::shared_ptr<const ReviewSheets>> layOutReview(const ReviewExport& review,
                                                         std::shared_ptr<const ReviewStudy> study,
                                                         const BookSettings& settings, Progress& progress,
                                                         const std::stop_token& stop);

/// Writes the files of `noonmark-cli review run`. Errors of writeReviewFiles(). Returns the paths written.
Result<std::vector<std::filesystem::path>> writeReview(const ReviewExport& review, const ReviewSheets& sheets,
                                                       const std::filesystem::path& folder,
                                                       Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
