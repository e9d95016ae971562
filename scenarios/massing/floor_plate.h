#pragma once

#include <span>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

/// Error: a use without a name, a number of storeys out of range, or "all storeys above" below another use.
Result<void> checkUses(const std::vector<FloorUse>& uses);

/// Gives each use its storeys, from the ground floor up. Storeys above the last use get an entry without a
/// use; a use above the tower's top has 0 storeys. Empty where no use is stated.
std::vector<UseArea> sumByUse(const std::vector<FloorUse>& uses, std::span<const double> storeyM2);

using Plate = std::vector<Footprint>;  ///< disjoint pieces

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

/// The plate of a volume at `heightM` above the ground, between its bottom and its top.
Plate plateAt(const Tier& tier, double heightM);
/// Its area, m2, without making it.
double plateAreaAt(const Tier& tier, double heightM);
Plate topPlateOf(const Tier& tier);

/// Largest turn between two levels of points on a twisted wall. Between levels, each wall is four triangles
/// around its middle; on a wall 40 m long they differ from the ideal surface by at most 0.09 m.
inline constexpr double maxTurnBetweenLevelsDeg = 2;

/// Heights above the ground at which a volume has points: bottom and top; where it is twisted also the floor
/// of each storey, and levels between them so that none is turned by more than maxTurnBetweenLevelsDeg
/// against the next.
std::vector<double> levelsOf(const Tier& tier, double storeyHeightM);

/// The closed mesh of one piece of a volume's plate, on z = 0. About 0.1 ms for a hundred levels.
TriangleMesh makeLeaningMesh(const Tier& tier, const Footprint& piece, double storeyHeightM);

/// Whether a volume stays over `lot` at all levels; checked every 5 degrees.
bool staysOn(const Tier& tier, const Footprint& lot);

}  // namespace noonmark
