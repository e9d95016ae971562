#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// What a change of the city makes of the receivers of a tile whose cells all have numbers.
struct ChangedCells {
    /// Of each block, those that have become receivers or lie at another height.
    std::vector<ReceiverBlocks::Masks> newRows, newColumns;
    std::vector<std::size_t> newBlocks;                  ///< with such cells
    std::vector<std::uint32_t> newNumbers, goneNumbers;  ///< of such, and of receivers that are none any more
};

/// `groundBeforeM`: as in Receivers.
ChangedCells changedCells(const ReceiverBlocks& now, const ReceiverBlocks& before, const Receivers& receivers,
                          std::span<const float> groundBeforeM);

}  // namespace noonmark
