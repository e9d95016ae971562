#pragma once

#include <string>

#include "core/city/building.h"
#include "core/samples/lots.h"

namespace noonmark {

struct LotBuildingSettings {
    double heightM = 20;
    int roundness = 0;  ///< extra points on each curved facade
};

/// A plausible building on a lot, inside its ground: row house, L, U, courtyard, bowed front, podium with a
/// square or round tower, or setbacks in three tiers, as height, width and chance have it. On a lot that is
/// cut the building follows the cut. Its footprints are simple as they are made, or repaired. No parts where
/// the ground is too small for any.
Building buildOnLot(const Lot& lot, const LotBuildingSettings& settings, const StreetAxes& axes,
                    SampleRandom& random);

/// A prism from street axes. The outline counter-clockwise, holes clockwise; what is not simple is repaired.
std::vector<Part> makePrism(const std::vector<StreetPolygon>& rings, double bottomM, double topM,
                            const StreetAxes& axes);

}  // namespace noonmark
