#pragma once

#include "app/report/book/book.h"
#include "core/io/heights/height_facts.h"
#include "core/study/windows/window_text.h"

namespace noonmark {

/// What the book of a review of windows is made from. All but the heights must outlive the call.
struct WindowBookSource {
    const WindowStudy& study;
    const ReviewLabels& labels;
    const City& baseline;
    const City& scenario;
    HeightFacts heights{};
};

/// The book of a review of windows: summary with counts, elevations (window_elevations.h), views from the sun
/// where the rule asks for them (window_sun_views.h), buildings, windows (the worst first; of more than
/// `mostWindowRows` the rest is in windows.csv only), method and sources. Errors of makeWindowSunViews().
Result<Book> makeWindowBook(const WindowBookSource& source, const BookSettings& settings, Progress& progress,
                            const std::stop_token& stop);
inline constexpr std::size_t mostWindowRows = 2000;

}  // namespace noonmark
