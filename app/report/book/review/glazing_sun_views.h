#pragma once

#include "app/report/book/review/glazing_book.h"

namespace noonmark {

/// Whether the diagrams of a rule have views from the sun.
bool hasSunViews(const Rule& rule);

/// The city seen from the sun at the times of the rule's diagrams, baseline and scenario side by side: around
/// what changes and the reviewed windows near it. None where the rule asks for none. Errors of
/// computeRuleMoments(), out of memory, or cancelled().
Result<std::vector<BookPage>> makeGlazingSunViews(const GlazingBookSource& source,
                                                  const BookSettings& settings, Progress& progress,
                                                  const std::stop_token& stop);

}  // namespace noonmark
