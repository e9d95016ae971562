#pragma once

#include "app/report/book/review/window_book.h"

namespace noonmark {

/// The sides of the reviewed buildings, coloured by each of listWindowMeasures(): baseline, scenario and
/// change on locked scales, with marks of verdicts. Buildings whose windows get worse come first, then those
/// that fail. At most `mostElevationPages` a measure.
std::vector<BookPage> makeWindowElevations(const WindowBookSource& source, const BookSettings& settings);
inline constexpr std::size_t mostElevationPages = 40;

}  // namespace noonmark
