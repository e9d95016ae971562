#pragma once

// Step masks by projected shadows. dense_blocks.h (this file) divides receivers that lie scattered over a
// city into dense rectangles; caster_groups.h orders casters by neighbourhood and caster_reach.h tells which
// of them reach a rectangle at some steps; block_filler.h fills one window at eight steps; and
// projected_masks.h runs a period.

#include <cstdint>
#include <vector>

#include "core/engines/projected/filling/bit_raster.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Neighbouring receivers in a row of the grid.
struct ReceiverRun {
    int column = 0, row = 0;  ///< of the first one, in the grid
    int count = 0;
    std::uint32_t first = 0;  ///< its index in Receivers::cells; those of the others follow
};

/// A rectangle of the receivers' grid, densely filled with receivers.
struct ReceiverBlock {
    int west = 0, east = 0;  ///< columns [west, east) of the grid
    RowBand band;            ///< rows of the grid
    std::vector<ReceiverRun> runs;

    /// Of its rasters: from the last multiple of 64 columns before its west.
    [[nodiscard]] BitLayout layout() const { return {east, band.rows(), west / 64}; }
};

/// Divides receivers into windows that do not overlap and of which about a third or more are receivers, or
/// that are small. Parks all over a city so cost little more than their own area. O(receivers log receivers).
std::vector<ReceiverBlock> divideIntoBlocks(const Receivers& receivers);

/// The raster in which every cell of the window's layout but its receivers is set.
std::vector<std::uint64_t> rasterWithoutReceivers(const ReceiverBlock& window);

}  // namespace noonmark
