#pragma once

#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// Area of the intersection of two footprints, square metres. An overlay without its shape: the sum over all
/// pairs of edges of the area under both, which needs no intersection points to be exact, and takes some
/// microseconds where GEOS takes a hundred. Accurate to about 1e-9 of their areas. O(edges of a * edges of
/// b).
double computeSharedArea(const Footprint& a, const Footprint& b);

/// The area of `pieces` that none of `others` covers lies between these two, square metres. They are equal,
/// but for rounding, where no three footprints share an area.
struct OutsideArea {
    double minM2 = 0;
    double maxM2 = 0;
};

/// `pieces` do not overlap each other; `others` may. Where there are too many edges to compare them in a
/// millisecond or so, the bounds are 0 and the whole area.
OutsideArea boundAreaOutside(const std::vector<Footprint>& pieces, const std::vector<Footprint>& others);

/// Number of points of all rings.
std::size_t countPoints(const std::vector<Footprint>& footprints);

}  // namespace noonmark
