#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The part of a bin that a sweep needs.
struct SweptBin {
    glm::dvec2 away;     ///< unit vector in which shadows fall
    HorizonCode lowest;  ///< of the lowest sun, or lower: horizons below it hide no sun
};

/// Neighbouring bins [first, end) whose azimuths are so close that nearly the same walls matter to all.
struct BatchRange {
    std::size_t first, end;
    [[nodiscard]] std::size_t size() const { return end - first; }
};

std::vector<SweptBin> makeSweptBins(std::span<const AzimuthBin> bins);

/// Splits bins, in order of azimuth, into batches of at most BatchLanes::maximum bins whose shadows run along
/// the same grid axis and in the same direction on it.
std::vector<BatchRange> groupIntoBatches(std::span<const SweptBin> bins);

/// The azimuths of a batch as a structure of arrays, one lane per azimuth; lanes after the last repeat it.
/// The result of one azimuth does not depend on the others, to the last bit.
struct BatchLanes {
    static constexpr int maximum = 8;
    explicit BatchLanes(std::span<const SweptBin> bins, double cellM);

    int count;
    AzimuthBatch batch;                         ///< centred on the middle azimuth
    alignas(64) double k[maximum];              ///< as in ShadowAxes
    alignas(64) double alongPerMetre[maximum];  ///< `rise` of a wall per metre of its height (WallPiece)
    alignas(64) float riseOfMiddle[maximum];    ///< the same for the middle azimuth
    alignas(
        64) float minOff[maximum];  ///< lower bound of the q of a block's cells relative to its first cell
    alignas(64) float maxOff[maximum];       ///< upper bound of the same
    alignas(64) float cotOfLowest[maximum];  ///< of the lowest sun; minus infinity after the last bin
    float lowestTan = 0;                     ///< parameter of BinWalls::find()
};

}  // namespace noonmark
