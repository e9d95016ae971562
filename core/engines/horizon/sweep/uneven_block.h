#pragma once

#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

/// The horizons of a block's cells that lie at heights of their own, under edges that rise and fall.
struct UnevenHorizons : BlockHorizons {
    Floats16 grounds[ReceiverBlocks::side];  ///< heights in the unit of WallOnBlock::rise
};

/// `risePerMetre`: rises a metre.
void setGrounds(const BlockGround& ground, float risePerMetre, Floats16* grounds);

/// As for BlockHorizons; a cell that lies higher than the edge stays as it is. On level ground and under
/// level edges the same bits.
void raiseBlock(const WallOnBlock& wall, const BlockRows& lines, UnevenHorizons& horizons);

/// How high an obstacle must reach to be seen from a block's cells over the horizons that they have already.
struct BlockNeed {
    Floats16 tans[ReceiverBlocks::side];     ///< of the horizons, not below that of the lowest sun
    Floats16 grounds[ReceiverBlocks::side];  ///< as in UnevenHorizons
};

/// `cots`: line by line, as in BlockHorizons. `lowest`: of a horizon that hides a sun.
void findNeed(const Floats16* cots, const Floats16* grounds, float lowest, BlockNeed& need);

/// Of an obstacle `distance` before the block's first line (in `along`, negative: behind it), or farther from
/// the sun's side: no cell sees one below, wide of rounding. 20 ns.
float findLeastRise(const BlockNeed& need, const BlockRows& lines, float distance);

/// The horizon that an edge gives a line's cells; the same sums as under level walls.
struct EdgeHorizon {
    alignas(
        64) float cot[lanesPerVector];  ///< infinite or no number where the cell lies higher than the edge
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
