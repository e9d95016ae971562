#pragma once

#include "app/report/book/book.h"
#include "core/study/study.h"

namespace noonmark {

/// The book of the contributions of a study: a map that numbers the buildings that make most shadow, bars of
/// the largest, and a table of all that make at least a thousandth of it, with the sum of the others. The
/// study's breakdown must exist; the study must outlive the book.
Book makeContributionBook(const Study& study, const BookSettings& settings);

}  // namespace noonmark
