#pragma once

#include "app/report/book/book.h"
#include "core/io/heights/height_facts.h"
#include "core/study/glazing/glazing_text.h"

namespace noonmark {

/// What the book of a review of windows is made from. All but the heights must outlive the call.
struct GlazingBookSource {
    const GlazingStudy& study;
    const ReviewLabels& labels;
    const City& baseline;
    const City& scenario;
    HeightFacts heights{};
};

/// The book of a review of windows: summary with counts, elevations and, where the rule asks for them, views
/// from the sun (glazing_pictures.h), buildings, windows (the worst first; of more than `maxGlazingRows` the
/// rest is in windows.csv only), method and sources. Errors of makeGlazingSunViews().
Result<Book> makeGlazingBook(const GlazingBookSource& source, const BookSettings& settings,
                             Progress& progress, const std::stop_token& stop);
inline constexpr std::size_t maxGlazingRows = 2000;

}  // namespace noonmark
