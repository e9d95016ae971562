#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/building_heights.h"
#include "core/city/city.h"
#include "core/city/footprints/footprint.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

// Changes of a lot's outer ring. Corner i begins edge i, which ends at the next corner. Holes stay. Error of
// all: sides would cross or touch each other, or nothing would be left. The order of corners turns round
// where a corner is moved through the opposite side, so that the ring stays counter-clockwise.

Result<Footprint> moveCorner(const Footprint& lot, std::size_t corner, glm::dvec2 to);

/// Moves an edge parallel to itself, outwards by `byM` metres, inwards if it is negative. The sides beside it
/// keep their directions, and become longer or shorter; a side that goes on straight from the edge stays, and
/// a new side joins the two. Error also: the sides beside it would have no length left.
Result<Footprint> moveEdge(const Footprint& lot, std::size_t edge, double byM);

/// Adds a corner in the middle of an edge: corner `edge` + 1.
Result<Footprint> insertCorner(const Footprint& lot, std::size_t edge);

/// Error also: only three corners are left.
Result<Footprint> removeCorner(const Footprint& lot, std::size_t corner);

/// Unit vector across an edge, out of the lot.
glm::dvec2 outwardOf(const Footprint& lot, std::size_t edge);

/// The union of the outlines of all parts that stand on the ground, or of all parts where every part is an
/// overhang. Several pieces where they do not touch.
std::vector<Footprint> computeOutline(const Building& building);

/// Demolitions of all buildings whose centroid lies on the lot.
std::vector<Edit> clearing(const City& city, const Footprint& lot);

/// A variant of a building with the same gross floor area on a plate `plateFactor` times as large
/// (findSameFloorArea()). It keeps the building's id, name and place in the list. Errors as of
/// findSameFloorArea().
struct Variant {
    Replace edit;
    Massing massing;
    double grossFloorM2 = 0;  ///< of the original building
};
Result<Variant> makeVariant(const City& city, std::size_t building, const Footprint& lot, double plateFactor,
                            double storeyHeightM = defaultStoreyM);

}  // namespace noonmark
