#pragma once

#include <glm/vec2.hpp>

#include "core/engines/horizon/geometry/azimuth_batch.h"

namespace noonmark {

/// A wall relative to a block's first cell.
struct WallAhead {
    glm::dvec2 low, high;  ///< across and along of the cell minus those of the wall's ends
    float topM;            ///< height
    float nearestAlong;    ///< `along` of the block's nearest cells minus that of the wall's farthest point
};

/// The same at each azimuth of a batch, with the meaning of WallOnBlock.
struct WallInBatch {
    alignas(64) float low[BatchLanes::most], high[BatchLanes::most];
    alignas(64) float slope[BatchLanes::most], perRise[BatchLanes::most];
};

/// Fills `in` and returns as bits the azimuths at which the wall faces away from the sun and may raise a
/// horizon with one of these cotangents; entries of other azimuths are unspecified. The margin exceeds
/// rounding, so azimuths that are left out change no bit. 5 ns.
unsigned findRaisingAzimuths(const BatchLanes& batch, const float* cots, const WallAhead& wall,
                             WallInBatch& in);

}  // namespace noonmark
