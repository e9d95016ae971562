#pragma once

#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/city/storeys.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

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
