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
/// from the sun (glazing_pictures.cpp), buildings, windows (the worst first; of more than
/// `defaultGlazingRows` or, where all pages are asked for, `maxGlazingRows` the rest is in windows.csv only),
/// method and sources. Errors of makeGlazingSunViews().
Result<Book> makeGlazingBook(const GlazingBookSource& source, const BookSettings& settings,
                             Progress& progress, const std::stop_token& stop);
inline constexpr std::size_t maxGlazingRows = 2000, defaultGlazingRows = 150;

/// The sides of the reviewed buildings, coloured by each of listGlazingMeasures(): baseline, scenario and
/// change on locked scales, with marks of verdicts. Buildings whose windows get worse come first, then those
/// that fail. At most `maxElevationPages` a measure or, unless all pages are asked for,
/// `defaultElevationPages` of all measures.
std::vector<BookPage> makeGlazingElevations(const GlazingBookSource& source, const BookSettings& settings);
inline constexpr std::size_t maxElevationPages = 40, defaultElevationPages = 12;

/// Whether the diagrams of a rule have views from the sun.
bool hasSunViews(const Rule& rule);

/// The city seen from the sun at the times of the rule's diagrams, baseline and scenario side by side: around
/// what changes and the reviewed windows near it. None where the rule asks for none. Errors of
/// computeRuleMoments(), out of memory, or cancelled().
Result<std::vector<BookPage>> makeGlazingSunViews(const GlazingBookSource& source,
                                                  const BookSettings& settings, Progress& progress,
                                                  const std::stop_token& stop);

}  // namespace noonmark
