#pragma once

#include <algorithm>
#include <vector>

#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// The cells of a tile whose horizons are kept: its receivers, and cells that were receivers before the
/// buildings that came last stood there.
class KnownCells {
public:
    /// Those of the receivers only, whose cells all have numbers.
    explicit KnownCells(const ReceiverBlocks& blocks) {
        for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
            rows_.push_back(blocks.masks(i, false));
            columns_.push_back(blocks.masks(i, true));
        }
    }

    [[nodiscard]] const ReceiverBlocks::Masks& masks(std::size_t block, bool swapped) const {
        return swapped ? columns_[block] : rows_[block];
    }
    [[nodiscard]] bool has(const ReceiverBlocks::Seat& seat) const {
        return (rows_[seat.block][std::size_t(seat.y)] >> unsigned(seat.x) & 1U) != 0;
    }
    void add(const ReceiverBlocks::Seat& seat) {
        rows_[seat.block][std::size_t(seat.y)] |= std::uint16_t(1U << unsigned(seat.x));
        columns_[seat.block][std::size_t(seat.x)] |= std::uint16_t(1U << unsigned(seat.y));
    }

private:
    std::vector<ReceiverBlocks::Masks> rows_, columns_;
};

}  // namespace noonmark
