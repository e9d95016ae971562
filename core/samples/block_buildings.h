#pragma once

#include <functional>
#include <vector>

#include "core/samples/lot_building.h"

namespace noonmark {

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
