#pragma once

#include "core/city/meshes/mesh.h"
#include "scenarios/massing/floor_plate.h"

namespace noonmark {

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
