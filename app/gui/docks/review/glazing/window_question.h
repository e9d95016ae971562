#pragma once

#include <memory>

#include "app/gui/docks/review/review_choice.h"
#include "app/report/book/book.h"
#include "core/io/files/check_output.h"
#include "core/study/windows/window_study.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

/// A review of windows, complete: it can be computed on another thread.
struct WindowQuestion {
    Rule rule;
    std::string from, to;  ///< names of baseline and scenario
    std::shared_ptr<const City> before, after;
    WindowReviewSettings settings;
};

/// Whether both have the same answer.
bool isSame(const WindowQuestion& a, const WindowQuestion& b);

/// A question with its answer.
struct WindowAnswer {
    WindowQuestion question;
    WindowStudy study;
};

/// The file of windows is hashed as it is read. Errors of runWindowReview() and of reading.
Result<WindowAnswer> computeWindowReview(const WindowQuestion& question, Progress& progress,
                                         const std::stop_token& stop);

/// What the files of a review of windows are made from.
struct WindowExport {
    std::shared_ptr<const WindowAnswer> answer;
    Project project;
    std::optional<ProjectFile> file;  ///< none: the project was never saved
    Warnings ofRules;                 ///< of reading the library of rules
    BookSettings sheets;
    OutputRules outputs;  ///< which files may be replaced
};

/// Writes the files of `noonmark-cli review run --windows`. Errors of writeWindowFiles(). Returns the paths.
Result<std::vector<std::filesystem::path>> writeWindowReview(const WindowExport& review,
                                                             const std::filesystem::path& folder,
                                                             Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
