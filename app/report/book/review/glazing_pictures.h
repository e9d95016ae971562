#pragma once

#include "app/report/book/review/glazing_book.h"

namespace noonmark {

/// The sides of the reviewed buildings, coloured by each of listGlazingMeasures(): baseline, scenario and
/// change on locked scales, with marks of verdicts. Buildings whose windows get worse come first, then those
/// that fail. At most `maxElevationPages` a measure.
std::vector<BookPage> makeGlazingElevations(const GlazingBookSource& source, const BookSettings& settings);
inline constexpr std::size_t maxElevationPages = 40;

/// Whether the diagrams of a rule have views from the sun.
bool hasSunViews(const Rule& rule);

/// The city seen from the sun at the times of the rule's diagrams, baseline and scenario side by side: around
/// what changes and the reviewed windows near it. None where the rule asks for none. Errors of
/// computeRuleMoments(), out of memory, or cancelled().
Result<std::vector<BookPage>> makeGlazingSunViews(const GlazingBookSource& source,
                                                  const BookSettings& settings, Progress& progress,
                                                  const std::stop_token& stop);

}  // namespace noonmark
