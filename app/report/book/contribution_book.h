#pragma once

#include "app/report/book/book.h"
#include "core/study/study.h"

namespace noonmark {

/// The book of the contributions of a study: a map with the buildings that take most numbered, bars of the
/// largest, and a table of all that take at least a thousandth of the shadow, with the sum of the others. The
/// study's breakdown must exist and hold buildings; the study must outlive the book.
Book makeContributionBook(const Study& study, const BookSettings& settings);

}  // namespace noonmark
