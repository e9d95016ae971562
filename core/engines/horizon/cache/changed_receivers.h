#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/cache/cached_cells.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Cells of the grid, ascending, that became receivers, ceased to be receivers or lie at another height.
/// Heights are not compared if the ground is level in only one of the two.
std::vector<std::uint32_t> findChangedReceivers(const Receivers& before, const Receivers& now);

/// The effect of a change of the city on the receivers of a tile whose cells all have numbers.
struct ChangedReceivers {
    /// For each block, cells that became receivers or lie at another height.
    std::vector<ReceiverBlocks::Masks> newRows;
    /// The subset whose horizons are not known.
    std::vector<ReceiverBlocks::Masks> unknownRows, unknownColumns;
    std::vector<std::size_t> newBlocks;                  ///< blocks with new cells
    std::vector<std::uint32_t> newNumbers, goneNumbers;  ///< of new and of former receivers
};

/// Updates `blocks` to the current receivers; new receivers become known. `cells`: from
/// findChangedReceivers(), may include cells of other tiles.
ChangedReceivers update(ReceiverBlocks& blocks, CachedCells& known, const Receivers& now,
                        std::span<const std::uint32_t> cells);

}  // namespace noonmark
