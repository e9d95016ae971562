#pragma once

#include "app/questions/review_question.h"
#include "core/study/windows/window_study.h"

namespace noonmark {

/// A review of windows, complete: it can be computed on another thread.
struct WindowQuestion : ReviewedCities {
    Rule rule;
    WindowReviewSettings settings;
    std::vector<CommandOption> repeat{};  ///< further options of the command that asks the same
};

/// Whether both have the same answer.
bool isSame(const WindowQuestion& a, const WindowQuestion& b);

/// A question with its answer.
struct WindowAnswer {
    WindowQuestion question;
    WindowStudy study;
};

/// The file of windows is hashed as it is read. `announce`: see runWindowReview(). Errors of
/// runWindowReview() and of reading.
Result<WindowAnswer> computeWindowReview(const WindowQuestion& question, Progress& progress,
                                         const std::stop_token& stop, const AnnounceWindows& announce = {});

/// The files of a review of windows, with what they state.
struct WrittenWindows {
    WindowStudy study;  ///< with all warnings
    ReviewLabels labels;
    std::vector<std::filesystem::path> files;
};

/// Writes the files of a review of windows. `byteOrderMark`: windows.csv begins with one. Errors of
/// writeWindowFiles().
Result<WrittenWindows> writeWindowReview(WindowAnswer answer, const ReviewSource& source,
                                         const BookSettings& sheets, const std::filesystem::path& folder,
                                         bool byteOrderMark, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
