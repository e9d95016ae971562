#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The cells of a tile whose horizons are cached: its receivers, and cells that were receivers until the
/// buildings added by the last change covered them.
class CachedCells {
public:
    /// Initially the receivers of `blocks`, all of whose cells have numbers.
    explicit CachedCells(const ReceiverBlocks& blocks) {
        for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
            rows_.push_back(blocks.masks(i, false));
            columns_.push_back(blocks.masks(i, true));
        }
    }

    [[nodiscard]] const ReceiverBlocks::Masks& masks(std::size_t block, bool swapped) const {
        return swapped ? columns_[block] : rows_[block];
    }
    [[nodiscard]] bool has(const ReceiverBlocks::CellSlot& slot) const {
        return (rows_[slot.block][std::size_t(slot.y)] >> unsigned(slot.x) & 1U) != 0;
    }
    void add(const ReceiverBlocks::CellSlot& slot) {
        rows_[slot.block][std::size_t(slot.y)] |= std::uint16_t(1U << unsigned(slot.x));
        columns_[slot.block][std::size_t(slot.x)] |= std::uint16_t(1U << unsigned(slot.y));
    }

private:
    std::vector<ReceiverBlocks::Masks> rows_, columns_;
};

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
