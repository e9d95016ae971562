#pragma once

#include "app/report/book/book.h"
#include "core/study/elements/element_map.h"
#include "core/study/study.h"

namespace noonmark {

/// The book of a study at points: figures, method and sources; and each side of each building that has
/// points, coloured by hours of sun a day on one scale, those with least sun first. Points of a level plane
/// and roof windows have no elevation. At most 40 pages of elevations, at `settings.scale` where they fit.
Book makeElementBook(const ElementStudy& study, const ElementMap& map, const BookSettings& settings);

/// The book of the contributions of a study: a map that numbers the buildings that make most shadow, bars of
/// the largest, and a table of all that make at least a thousandth of it, with the sum of the others. The
/// study's breakdown must exist; the study must outlive the book.
Book makeContributionBook(const Study& study, const BookSettings& settings);

}  // namespace noonmark
