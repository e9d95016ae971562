#pragma once

#include <vector>

#include "scenarios/massing/massing.h"

namespace noonmark {

using Plate = std::vector<Footprint>;  ///< disjoint pieces

double computeArea(const Plate& plate);

/// Insets the lot until it has the requested area (to 1e-4 of it). Error: the area is larger than the lot, or
/// nothing is left.
Result<Plate> makePlate(const Footprint& lot, const PlateSize& size);

/// The centroid of the plate's outlines, local metres: what it is turned and scaled about.
glm::dvec2 findMiddle(const Plate& plate);

/// The plate scaled and turned about its centroid. `scale` > 0.
Plate placePlate(const Plate& plate, double scale, double clockwiseDeg);

/// Turns the plate about the centroid of its area.
Plate turnPlate(const Plate& plate, double clockwiseDeg);

/// Moves all edges inwards. Error, with the largest possible inset, where nothing is left.
Result<Plate> insetPlate(const Plate& plate, double insetM);

/// Whether the plate lies on `ground`, with a tolerance for inexact drawing (0.02 % of its area, and 0.05
/// m2).
bool liesOn(const Plate& plate, const Plate& ground);

/// Scales the plate about its centroid until it has `areaM2` (to 1e-4); an enlarged plate is cut by the lot.
/// `areaM2` is at most the lot's area, and the plate lies on the lot.
Plate resizePlate(const Plate& plate, const Footprint& lot, double areaM2);

}  // namespace noonmark
