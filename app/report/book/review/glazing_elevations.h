#pragma once

#include "app/report/book/review/glazing_book.h"

namespace noonmark {

/// The sides of the reviewed buildings, coloured by each of listGlazingMeasures(): baseline, scenario and
/// change on locked scales, with marks of verdicts. Buildings whose windows get worse come first, then those
/// that fail. At most `maxElevationPages` a measure.
std::vector<BookPage> makeGlazingElevations(const GlazingBookSource& source, const BookSettings& settings);
inline constexpr std::size_t maxElevationPages = 40;

}  // namespace noonmark
