#pragma once

#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

/// The horizons of a block whose cells have individual heights, below edges whose height varies.
struct UnevenHorizons : BlockHorizons {
    Floats16 grounds[ReceiverBlocks::side];  ///< heights in the unit of WallOnBlock::rise
};

/// `risePerMetre`: rise per metre of height.
void setGrounds(const BlockGround& ground, float risePerMetre, Floats16* grounds);

/// As for BlockHorizons; cells above the edge are not changed. On level ground and below level edges it gives
/// the same bits.
void raiseBlock(const WallOnBlock& wall, const BlockRows& rows, UnevenHorizons& horizons);

/// How high an obstacle must reach to be seen from a block's cells above their current horizons.
struct BlockNeed {
    Floats16 tans[ReceiverBlocks::side];     ///< of the horizons, at least that of the lowest sun
    Floats16 grounds[ReceiverBlocks::side];  ///< as in UnevenHorizons
};

/// `cots`: row by row, as in BlockHorizons. `lowest`: cotangent of the lowest horizon that hides a sun.
void findNeed(const Floats16* cots, const Floats16* grounds, float lowest, BlockNeed& need);

/// The smallest rise, less a margin for rounding, at which some cell can see an obstacle `distance` or more
/// before the block's first row (in `along`; negative: behind it). 20 ns.
float findLeastRise(const BlockNeed& need, const BlockRows& rows, float distance);

/// The horizon that an edge gives the cells of a row; the same operations as for level walls.
struct EdgeHorizon {
    alignas(64) float cot[lanesPerVector];            ///< infinite or NaN if the cell is above the edge
    alignas(64) std::int32_t shaded[lanesPerVector];  ///< whether the edge is before the cell
};
[[gnu::always_inline]] inline void findHorizon(const WallOnBlock& wall, float shift, float along,
                                               const float* ground, EdgeHorizon& horizon) {
    const float low = wall.low - shift, high = wall.high - shift;
    const float distance = (wall.along + along) - wall.slope * low;
    for (int i = 0; i < lanesPerVector; ++i) {
        const float over = wall.rise + wall.riseSlope * (float(i) + low) - ground[i];
        const float perRise = 1 / (over > 0 ? over : 0);
        const float cot = distance * perRise - wall.slope * perRise * float(i);
        const bool before = (float(i) + low >= 0) & (float(i) + high < 0);
        horizon.shaded[i] = before & (cot > wall.nearest * perRise);
        horizon.cot[i] = cot > 0 ? cot : 0;
    }
}

}  // namespace noonmark
