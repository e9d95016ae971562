#pragma once

#include <limits>

#include "core/city/building_heights.h"
#include "scenarios/massing/floor_plate.h"
#include "scenarios/massing/massing.h"

namespace noonmark {

/// A tower's settings for another lot, and what had to change.
struct CopiedMassing {
    MassingSettings settings;
    bool plateReduced = false;  ///< the other lot, or the podium on it, is smaller than the plate
    bool turnDropped = false;   ///< turned, the plate would leave the other lot
    bool twistDropped = false;  ///< twisted, a volume would leave the other lot
    int setbacksDropped = 0;    ///< from the top: they would leave nothing of the plate
    bool operator==(const CopiedMassing&) const = default;
};

/// Settings that build on `to` the tower that `settings` build on `from`: storeys, heights and setbacks stay,
/// plates keep their area in m2. A plate takes the shape of its lot, so the tower turns with it. What is not
/// possible there is changed as little as possible; CopiedMassing states what. Error, as of makeMassing(): no
/// tower is possible. Some 5 ms for each plate tried.
Result<CopiedMassing> copyMassing(const Footprint& from, const MassingSettings& settings,
                                  const Footprint& to);

/// What a reshaped massing must preserve.
struct PreservedFloorArea {
    Plate plate;              ///< where the building touches the ground
    double grossFloorM2 = 0;  ///< preserved
    double storeyHeightM = defaultStoreyM;
    int estimatedStoreys = 0;  ///< of open meshes (core/city/meshes/mesh_section.h)
};

PreservedFloorArea massOf(const Massing& massing);

/// Cuts an existing building into storeys of `storeyHeightM` (2 to 10), starting at `groundM` (local z)
/// (core/city/footprints/plan_areas.h). Error: it has less than one storey.
Result<PreservedFloorArea> massOf(const Building& building, double groundM, double storeyHeightM);

/// Plate factor for "the largest plate that the lot allows".
inline constexpr double largestPlate = std::numeric_limits<double>::infinity();

/// Finds one tower of the same gross floor area (to 0.1 %) on a plate `plateFactor` times as large: a factor
/// above 1 gives a lower, wider tower, below 1 a taller, slimmer one (paper, section 8.1: "we doubled the
/// floor plate size. For others, we used the largest floor plate size that could be accommodated"). A wider
/// plate keeps its shape and centroid and is cut by the lot; where the lot is too small, the plate is the
/// whole lot. The plate area is then adjusted so that the number of storeys is whole. Error: a factor of 0 or
/// less, a plate outside the lot, or more than 500 storeys or 2000 m; the last one states the smallest
/// possible plate.
Result<Massing> findSameFloorArea(const Footprint& lot, const PreservedFloorArea& given, double plateFactor);

}  // namespace noonmark
