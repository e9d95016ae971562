#pragma once

#include <functional>
#include <vector>

#include "core/samples/lot_building.h"

namespace noonmark {

/// What a quarter looks like.
struct BlockSettings {
    LotWidths widths;
    std::function<double(glm::dvec2 street)> medianHeightM;  ///< of a lot whose middle is there
    double heightSigma = 0.45;                               ///< of the logarithm of heights
    double lowestM = 7;
    double highestM = 420;
    int roundness = 0;
    std::vector<SkewedAvenue> avenues;  ///< cut lots
    std::vector<StreetBox> cleared;     ///< lots that overlap one of these stay empty
};

/// The buildings of one block, heights log-normal, in the order of its lots; narrow lots stay under nine
/// times their width.
std::vector<Building> buildOnLots(const StreetBox& block, const BlockSettings& settings,
                                  const StreetAxes& axes, SampleRandom& random);

}  // namespace noonmark
