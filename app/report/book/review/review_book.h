#pragma once

#include <stop_token>
#include <string>

#include "app/report/book/book.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/heights/height_facts.h"
#include "core/study/text/review_text.h"

namespace noonmark {

/// What a review's book is made from. All but the heights must outlive the call.
struct ReviewBookSource {
    const ReviewStudy& study;  ///< with timelines, or the book has no charts
    const ReviewLabels& labels;
    const City& baseline;
    const City& scenario;
    const std::vector<Place>& places;  ///< those that were reviewed; of rules with lines the parcels
    HeightFacts heights{};
    std::vector<Place> streets{};  ///< drawn for orientation
};

/// The options of `noonmark-cli review run` that lay out the same sheets: paper, scale, legend and printed
/// date. The rest of the title block is the project's.
std::vector<CommandOption> makeRepeatOptions(const BookSettings& settings);

/// The book of a review: summary with a picture of the worst moment, diagrams of the rule's days and hours,
/// views from the sun, timelines, the rule's table, method and sources. Computes the shadows of each diagram.
/// Errors of outlineShadows() and computeRuleSun(); cancelled().
Result<Book> makeReviewBook(const ReviewBookSource& source, const BookSettings& settings, Progress& progress,
                            const std::stop_token& stop);

}  // namespace noonmark
