#pragma once

#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

/// The horizons of a block whose cells have individual heights, below edges whose height varies.
struct UnevenHorizons : BlockHorizons {
    CacheLine<float> grounds[ReceiverBlocks::side];  ///< heights in the unit of WallOnBlock::rise
};

/// `risePerMetre`: rise per metre of height.
void setGrounds(const BlockGround& ground, float risePerMetre, CacheLine<float>* grounds);

/// As for BlockHorizons; cells above the edge are not changed. On level ground and below level edges it gives
/// the same bits.
void raiseBlock(const WallOnBlock& wall, const BlockRows& rows, UnevenHorizons& horizons);

/// How high an obstacle must reach to be seen from a block's cells above their current horizons.
struct BlockNeed {
    CacheLine<float> tans[ReceiverBlocks::side];     ///< of the horizons, at least that of the lowest sun
    CacheLine<float> grounds[ReceiverBlocks::side];  ///< as in UnevenHorizons
};

/// `cots`: row by row, as in BlockHorizons. `lowest`: cotangent of the lowest horizon that hides a sun.
void findNeed(const CacheLine<float>* cots, const CacheLine<float>* grounds, float lowest, BlockNeed& need);

/// The smallest rise, less a margin for rounding, at which some cell can see an obstacle `distance` or more
/// before the block's first row (in `along`; negative: behind it). 20 ns.
float findLeastRise(const BlockNeed& need, const BlockRows& rows, float distance);

}  // namespace noonmark
