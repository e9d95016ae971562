#pragma once

#include <cstdint>
#include <limits>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_layers.h"

namespace noonmark {

/// A block of cells, line by line (rows, or columns where shadows run along x), from which what hangs is
/// seen.
struct ViewingBlock {
    static constexpr HorizonCode blind = std::numeric_limits<HorizonCode>::max();  ///< no horizon is as high

    BlockCodes horizons;              ///< `blind` for cells that do not matter
    const float* groundsM = nullptr;  ///< above the datum; null: all lie on it
};

/// How a block lies at one azimuth.
struct BlockAxes {
    double q, along;      ///< of its first cell
    float shift;          ///< q falls by so much from line to line
    float sign;           ///< `along` grows by so much
    float alongPerMetre;  ///< cells along a metre of distance
};

/// Strips of a layer (OverhangStrip) side by side, as the block's first cell sees them: arrays of a number
/// each.
struct StripLanes {
    static constexpr int most = 16;
    int count = 0;
    alignas(64) float low[most], high[most];  ///< q
    /// At `low`, and what comes to it for each q.
    struct Side {
        alignas(64) float distance[most], slope[most], rise[most], riseSlope[most];
    };
    Side near, far;

    /// Only where it reaches into the block.
    void add(const OverhangStrip& strip, const BlockAxes& axes);
};

/// Cells that a layer is seen from, and where: distances and rises of its near and far side.
struct VisibleCells {
    static constexpr int most = ReceiverBlocks::cells, room = most + 16;
    int count = 0;
    alignas(64) std::int32_t cell[room];
    alignas(64) float toNear[room], toFar[room], nearRise[room], farRise[room];
};

/// Adds the cells with lowQ <= q < highQ of one of the strips that lie behind its far side and whose horizons
/// are no higher than `highest`. Strips that share a corner part the cells there between them. The same bits
/// on every instruction set. From 5 ns a line.
void addVisibleCells(const StripLanes& strips, const ViewingBlock& block, const BlockAxes& axes,
                     HorizonCode highest, VisibleCells& seen);

}  // namespace noonmark
