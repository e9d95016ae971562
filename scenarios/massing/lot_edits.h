#pragma once

#include <string>
#include <vector>

#include "core/city/city.h"
#include "scenarios/edits/edit.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

/// What a building covers where it stands, all parts together; several pieces where it stands in several.
std::vector<Footprint> computeOutline(const Building& building);

/// Demolitions of all buildings whose middle lies on the lot.
std::vector<Edit> clearing(const City& city, const Footprint& lot);

/// The storey height of buildings that do not say theirs, metres.
inline constexpr double usualStoreyM = 3.5;

/// A building's variant of the same gross floor area on a plate `plateFactor` times as large (sameFloorArea),
/// with its id, name and place in the list. Error: as of sameFloorArea.
struct Variant {
    Replace edit;
    Massing massing;
    double grossFloorM2 = 0;  ///< of the given building
};
Result<Variant> makeVariant(const City& city, std::size_t building, const Footprint& lot, double plateFactor,
                            double storeyHeightM = usualStoreyM);

}  // namespace noonmark
