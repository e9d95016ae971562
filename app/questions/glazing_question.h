#pragma once

#include "app/questions/review_question.h"
#include "core/study/glazing/glazing_study.h"

namespace noonmark {

/// A review of windows, complete: it can be computed on another thread.
struct GlazingQuestion : ReviewedCities {
    Rule rule;
    GlazingReviewSettings settings;
    std::vector<CommandOption> repeat{};  ///< further options of the command that asks the same
};

/// Whether both have the same answer.
bool isSame(const GlazingQuestion& a, const GlazingQuestion& b);

/// A question with its answer.
struct GlazingAnswer {
    GlazingQuestion question;
    GlazingStudy study;
};

/// The same as an answer that is shown, listed and exported.
std::shared_ptr<const Answer> makeAnswer(std::shared_ptr<const GlazingAnswer> review,
                                         std::shared_ptr<const ReviewSource> source);

/// The file of windows is hashed as it is read. `announce`: see runGlazingReview(). Errors of
/// runGlazingReview() and of reading.
Result<GlazingAnswer> computeGlazingReview(const GlazingQuestion& question, Progress& progress,
                                           const std::stop_token& stop, const AnnounceGlazing& announce = {});

}  // namespace noonmark
