#pragma once

#include <functional>
#include <string>
#include <vector>

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

/// The appearance of a quarter.
struct BlockSettings {
    LotWidths widths;
    /// Median height on a lot whose middle is at `street`
    std::function<double(glm::dvec2 street)> medianHeightM;
    double heightSigma = 0.45;  ///< standard deviation of the logarithm of heights
    double lowestM = 7;
    double highestM = 420;
    int roundness = 0;
    std::vector<SkewedAvenue> avenues;  ///< avenues that cut lots
    std::vector<StreetBox> cleared;     ///< lots that overlap one of these stay empty
};

/// The buildings of one block, with log-normal heights, in the order of its lots; narrow lots stay under nine
/// times their width.
std::vector<Building> buildOnLots(const StreetBox& block, const BlockSettings& settings,
                                  const StreetAxes& axes, SampleRandom& random);

}  // namespace noonmark
