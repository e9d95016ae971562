#pragma once

#include <vector>

#include "scenarios/massing/massing.h"

namespace noonmark {

using Plate = std::vector<Footprint>;  ///< disjoint pieces

double computeArea(const Plate& plate);

/// The lot's inset that has the area asked for (to 1e-4 of it). Error: larger than the lot, or nothing.
Result<Plate> makePlate(const Footprint& lot, const PlateSize& size);

/// Turned about the middle of its area.
Plate turned(const Plate& plate, double clockwiseDeg);

/// Inset on all sides. Error with the largest inset where nothing is left.
Result<Plate> insetPlate(const Plate& plate, double insetM);

/// Whether it lies on `ground` but for an inaccuracy of drawing (0.02 % of its area, and 0.05 m2).
bool liesOn(const Plate& plate, const Plate& ground);

/// The plate made larger about its middle and cut by the lot, so that it has `areaM2` (to 1e-4); or made
/// smaller. The area is at most the lot's, and the plate lies on the lot.
Plate resized(const Plate& plate, const Footprint& lot, double areaM2);

}  // namespace noonmark
