#pragma once

#include "app/report/book/book.h"
#include "core/io/heights/height_facts.h"
#include "core/study/windows/window_text.h"

namespace noonmark {

/// What the book of a review of windows is made from. All but the heights must outlive the call.
struct WindowBookSource {
    const WindowStudy& study;
    const ReviewLabels& labels;
    const City& scenario;
    HeightFacts heights{};
};

/// The book of a review of windows: summary with counts, buildings, windows (the worst first; of more than
/// `mostWindowRows` the rest is in windows.csv only), method and sources.
Book makeWindowBook(const WindowBookSource& source, const BookSettings& settings);
inline constexpr std::size_t mostWindowRows = 2000;

}  // namespace noonmark
