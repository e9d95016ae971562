#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/simd/simd_lanes.h"

namespace noonmark {

/// The horizon of each cell of a block of 16 x 16, line by line, as the cotangent of its altitude: distance
/// over height, which takes no division for each cell. The higher a horizon, the less.
struct BlockHorizons {
    static constexpr float nobody = -1;  ///< of cells that are no receivers: no horizon is higher
    Floats16 lines[ReceiverBlocks::side];
};

/// Cells, more than any computeNearestAlong().
inline constexpr float aheadBy = 0.1F;

/// How far along a cell counts as on a wall that takes `slope` cells along for each across. What is rounded
/// off the distance grows with the slope. `nearest`: on a wall square to the azimuth, either sign.
inline float computeNearestAlong(float nearest, float slope) {
    const float along = nearest * (1 + std::abs(slope));
    return std::clamp(along, -aheadBy / 2, aheadBy / 2);
}

/// How q and `along` go from a block's first line to its others.
struct BlockRows {
    BlockRows(double k, double sign);
    std::array<float, ReceiverBlocks::side> shifts;  ///< q falls by so much
    std::array<float, ReceiverBlocks::side> alongs;  ///< `along` grows by so much
    float linesAQ;                                   ///< lines for each q; 0 where q stays
};

/// A piece of wall as a block's first cell sees it; in cells.
struct WallOnBlock {
    float low, high;  ///< q of the cell, less lowQ and highQ of the piece
    float along;      ///< `along` of the cell, less that of the wall at lowQ
    float slope, rise, riseSlope, nearest;
    float perRise;          ///< 1 / rise
    bool ahead;             ///< all cells are farther behind it than `nearest`, and than 0
    std::int32_t building;  ///< only for who asks
};

/// The lines of a block, [first, end), with cells that a piece is wide enough to shade; or one more.
struct RowRange {
    int first, end;
};
RowRange linesOf(const WallOnBlock& wall, const BlockRows& lines);

/// Level for receivers, `nobody` for the rest.
void clearBlock(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons);

/// Raises horizons to those that some walls give them: of each wall cells with low + place >= 0 > high +
/// place that are farther behind it than `nearest`. A cell on a wall gets cotangent 0. Returns the cotangent
/// of the lowest horizon of all cells then; `nobody` where there are no receivers. The same bits on every
/// instruction set, in whatever order walls come. Some 20 ns a wall.
float raiseBlock(std::span<const WallOnBlock> walls, const BlockRows& lines, BlockHorizons& horizons);

/// Codes of all cells, 16 a line; noHorizon for those that hide no sun of code `lowest`, and for nobody's.
void toCodes(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes);

}  // namespace noonmark
