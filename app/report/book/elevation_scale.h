#pragma once

#include "app/report/book/elevation.h"

namespace noonmark {

/// The layout that shows an elevation of that size (metres) at that scale in so many panels within an area
/// (points); none if it does not fit.
std::optional<ElevationLayout> fitElevationAt(glm::dvec2 sizeM, std::size_t panels, const QSizeF& areaPt,
                                              double textScale, double scale);

}  // namespace noonmark
