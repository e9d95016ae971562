#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// The horizon of each cell of a 16 x 16 block, row by row, as the cotangent of its altitude: distance over
/// height, which needs no division per cell. The higher a horizon, the smaller the cotangent.
struct BlockHorizons {
    static constexpr float notReceiver = -1;  ///< for cells that are not receivers: no horizon is higher
    CacheLine<float> rows[ReceiverBlocks::side];
};

/// In cells; larger than any computeNearestAlong().
inline constexpr float aheadBy = 0.1F;

/// The distance along, in cells, up to which a cell counts as on a wall that runs `slope` cells along per
/// cell across; the rounding of the distance grows with the slope. `nearest`: the value for a wall at a right
/// angle to the azimuth, either sign.
inline float computeNearestAlong(float nearest, float slope) {
    const float along = nearest * (1 + std::abs(slope));
    return std::clamp(along, -aheadBy / 2, aheadBy / 2);
}

/// Changes of q and `along` from a block's first row to its other rows.
struct BlockRows {
    BlockRows(double k, double sign);
    std::array<float, ReceiverBlocks::side> shifts;  ///< decrease of q
    std::array<float, ReceiverBlocks::side> alongs;  ///< increase of `along`
    float rowsPerQ;                                  ///< rows per unit of q; 0 if q does not change
};

/// A piece of wall relative to a block's first cell; in cells.
struct WallOnBlock {
    float low, high;  ///< q of the cell minus lowQ and highQ of the piece
    float along;      ///< `along` of the cell minus that of the wall at lowQ
    float slope, rise, riseSlope, nearest;
    float perRise;          ///< 1 / rise
    bool ahead;             ///< all cells are farther behind it than `nearest` and than 0
    std::int32_t building;  ///< only for attribution
};

/// The rows [first, end) of a block with cells that lie within a piece's range of q; may contain a row too
/// many at either end.
struct RowRange {
    int first, end;
};
RowRange findRows(const WallOnBlock& wall, const BlockRows& rows);

/// Sets the horizons of receivers to level and those of other cells to `notReceiver`.
void clearBlock(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons);

/// Raises horizons to those of some walls. A wall affects cells with low + place >= 0 > high + place that are
/// farther behind it than `nearest`. A cell on a wall gets cotangent 0. Returns the cotangent of the lowest
/// horizon of all cells afterwards; `notReceiver` if there are no receivers. The same bits in whatever order
/// walls come. Some 20 ns per wall with AVX-512.
float raiseBlock(std::span<const WallOnBlock> walls, const BlockRows& rows, BlockHorizons& horizons);

/// Codes of all cells, 16 per row; noHorizon for cells whose horizon hides no sun of code `lowest` and for
/// cells that are not receivers.
void toCodes(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes);

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
float findMinRise(const BlockNeed& need, const BlockRows& rows, float distance);

}  // namespace noonmark
