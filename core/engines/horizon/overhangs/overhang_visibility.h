#pragma once

#include <cstdint>
#include <limits>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_layers.h"

namespace noonmark {

/// A block of cells from which overhangs are seen, row by row (column by column if shadows run along x).
struct ViewingBlock {
    static constexpr HorizonCode blind = std::numeric_limits<HorizonCode>::max();  ///< above any horizon

    BlockCodes horizons;              ///< `blind` for irrelevant cells
    const float* groundsM = nullptr;  ///< above the datum; null: all at the datum
};

/// Position of a block at one azimuth.
struct BlockAxes {
    double q, along;      ///< of its first cell
    float shift;          ///< decrease of q per row
    float sign;           ///< increase of `along` per row
    float alongPerMetre;  ///< cells along per metre of distance
};

/// Strips of a layer (OverhangStrip) relative to the block's first cell, as a structure of arrays.
struct StripLanes {
    static constexpr int most = 16;
    int count = 0;
    alignas(64) float low[most], high[most];  ///< q
    /// Values at `low` and their change per q.
    struct Side {
        alignas(64) float distance[most], slope[most], rise[most], riseSlope[most];
    };
    Side near, far;

    /// Adds the strip if it overlaps the block.
    void add(const OverhangStrip& strip, const BlockAxes& axes);
};

/// Cells that see a layer, with the distances and rises of its near and far side.
struct VisibleCells {
    static constexpr int most = ReceiverBlocks::cells, room = most + 16;
    int count = 0;
    alignas(64) std::int32_t cell[room];
    alignas(64) float toNear[room], toFar[room], nearRise[room], farRise[room];
};

/// Adds the cells within lowQ <= q < highQ of a strip that lie behind its far side and whose horizons are no
/// higher than `highest`. Strips must ascend; those that share a corner divide the cells there between them.
/// From 5 ns per row.
void addVisibleCells(const StripLanes& strips, const ViewingBlock& block, const BlockAxes& axes,
                     HorizonCode highest, VisibleCells& seen);

/// The altitudes that a layer hides from each of these cells: codes of its lower and upper end, with room for
/// VisibleCells::most. `solid`: the layer's far side is its upper one.
void findIntervals(const VisibleCells& seen, bool solid, HorizonCode* low, HorizonCode* high);

}  // namespace noonmark
