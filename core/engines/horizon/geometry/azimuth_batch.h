#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// A bin as a sweep sees it.
struct SweptBin {
    glm::dvec2 away;     ///< unit vector that shadows run along
    HorizonCode lowest;  ///< of its suns, or a lower one: horizons that hide no such sun don't count
};

/// Neighbouring bins [first, end) whose azimuths lie so near to each other that they see much the same walls.
struct BatchRange {
    std::size_t first, end;
    [[nodiscard]] std::size_t size() const { return end - first; }
};

std::vector<SweptBin> makeSweptBins(std::span<const AzimuthBin> bins);

/// Cuts bins, in order of azimuth, into batches of at most BatchLanes::most, along one side of the grid and
/// of one direction along it.
std::vector<BatchRange> groupIntoBatches(std::span<const SweptBin> bins);

/// The azimuths of a batch side by side: arrays of a number each, beyond the last one's again. What is said
/// of one azimuth does not depend on the others, to the last bit.
struct BatchLanes {
    static constexpr int most = 8;
    explicit BatchLanes(std::span<const SweptBin> bins, double cellM);

    int count;
    AzimuthBatch batch;                      ///< around the middle one
    alignas(64) double k[most];              ///< as in ShadowAxes
    alignas(64) double alongPerMetre[most];  ///< `rise` of a wall for each metre of its height (WallPiece)
    alignas(64) float riseOfMiddle[most];    ///< the same for that in the middle
    alignas(64) float leastOff[most];        ///< q of a block's cells less that of its first: no cell's is
    alignas(64) float mostOff[most];         ///< less or more
    alignas(64) float cotOfLowest[most];     ///< of its suns; beyond the last bin minus infinity
    float lowestTan = 0;                     ///< as BinWalls::find() wants it
};

}  // namespace noonmark
