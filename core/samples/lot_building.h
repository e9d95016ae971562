#pragma once

#include <string>

#include "core/city/building.h"
#include "core/samples/lots.h"

namespace noonmark {

struct LotBuildingSettings {
    double heightM = 20;
    int roundness = 0;  ///< extra points on each curved facade
};

/// Makes a plausible building on a lot, inside its ground: row house, L, U, courtyard, bowed front, podium
/// with a square or round tower, or setbacks in three tiers, chosen by height, width and chance. On a cut lot
/// the building follows the cut. Its footprints are simple or repaired. No parts if the ground is too small.
Building buildOnLot(const Lot& lot, const LotBuildingSettings& settings, const StreetAxes& axes,
                    SampleRandom& random);

/// A prism from a polygon in street axes. The outline counter-clockwise, holes clockwise; polygons that are
/// not simple are repaired.
std::vector<Part> makePrism(const std::vector<StreetPolygon>& rings, double bottomM, double topM,
                            const StreetAxes& axes);

}  // namespace noonmark
