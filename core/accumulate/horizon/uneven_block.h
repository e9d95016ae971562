#pragma once

#include "core/accumulate/horizon/block_grounds.h"
#include "core/accumulate/horizon/raise_block.h"

namespace noonmark {

/// The horizons of a block's cells that lie at heights of their own, under edges that rise and fall.
struct UnevenHorizons : BlockHorizons {
    Floats16 grounds[ReceiverBlocks::side];  ///< heights in the unit of WallOnBlock::rise
};

/// `risePerMetre`: rises a metre.
void setGrounds(const BlockGround& ground, float risePerMetre, Floats16* grounds);

/// As for BlockHorizons; a cell that lies higher than the edge stays as it is. On level ground and under
/// level edges the same bits.
void raiseBlock(const WallOnBlock& wall, const BlockLines& lines, UnevenHorizons& horizons);

/// How high an obstacle must reach to be seen from a block's cells over the horizons that they have already.
struct BlockNeed {
    Floats16 tans[ReceiverBlocks::side];     ///< of the horizons, not below that of the lowest sun
    Floats16 grounds[ReceiverBlocks::side];  ///< as in UnevenHorizons
};

/// `steepness`: line by line, as in BlockHorizons. `lowest`: of a horizon that hides a sun.
void findNeed(const Floats16* steepness, const Floats16* grounds, float lowest, BlockNeed& need);

/// Of an obstacle `distance` before the block's first line (in `along`, negative: behind it), or farther from
/// the sun's side: no cell sees one below, wide of rounding. 20 ns.
float leastRise(const BlockNeed& need, const BlockLines& lines, float distance);

/// Steepness that an edge gives a cell: at `low` past its beginning, `behind` it. 0, or no number, where the
/// cell lies higher.
[[gnu::always_inline]] inline void findSteepness(const WallOnBlock& wall, const Floats16& low,
                                                 const Floats16& behind, const Floats16& ground,
                                                 Floats16& steepness) {
    const Floats16 over = wall.rise + wall.riseSlope * low - ground;
    const Floats16 rise = over > 0 ? over : Floats16{};
    steepness = rise / (rise + behind);
}

}  // namespace noonmark
