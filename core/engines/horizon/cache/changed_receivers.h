#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/cache/cached_cells.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Cells of the grid, ascending, that have become receivers, are none any more, or lie at another height; of
/// level ground and uneven one heights are not compared.
std::vector<std::uint32_t> findChangedReceivers(const Receivers& before, const Receivers& now);

/// What a change of the city makes of the receivers of a tile whose cells all have numbers.
struct ChangedReceivers {
    /// Of each block, those that have become receivers or lie at another height.
    std::vector<ReceiverBlocks::Masks> newRows;
    /// Those of them whose horizons are not known.
    std::vector<ReceiverBlocks::Masks> unknownRows, unknownColumns;
    std::vector<std::size_t> newBlocks;                  ///< with new cells
    std::vector<std::uint32_t> newNumbers, goneNumbers;  ///< of such, and of receivers that are none any more
};

/// Makes blocks those of the receivers now; the new ones become known. `cells`: findChangedReceivers(),
/// perhaps of other tiles, too.
ChangedReceivers update(ReceiverBlocks& blocks, CachedCells& known, const Receivers& now,
                        std::span<const std::uint32_t> cells);

}  // namespace noonmark
