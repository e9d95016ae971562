#pragma once

#include <glm/vec2.hpp>

#include "core/engines/horizon/geometry/azimuth_batch.h"

namespace noonmark {

/// A wall as a block's first cell sees it.
struct WallAhead {
    glm::dvec2 low, high;  ///< across and along of the cell, less those of the wall's ends
    float topM;            ///< height
    float nearestAlong;    ///< `along` of the block's nearest cells, less that of the wall's farthest point
};

/// The same along each azimuth of a batch, as WallOnBlock.
struct WallInBatch {
    alignas(64) float low[BatchLanes::most], high[BatchLanes::most];
    alignas(64) float slope[BatchLanes::most], perRise[BatchLanes::most];
};

/// Fills `in`, and returns the azimuths, as bits, at which the wall faces away from the sun and may raise a
/// horizon of one of these cotangents; of others nothing is said. Wide of rounding: what is passed over
/// changes no bit. The same bits on every instruction set. 5 ns.
unsigned findRaisingAzimuths(const BatchLanes& lanes, const float* cots, const WallAhead& wall,
                             WallInBatch& in);

}  // namespace noonmark
