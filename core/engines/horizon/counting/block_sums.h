#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Steps hidden in the block of a tile, counted from codes line by line as a sweep gives them: no horizon
/// need be kept. 1 kB a block, twice where shadows run along both sides of the grid. For one thread.
class BlockSums {
public:
    /// No steps.
    void begin(std::size_t blockCount);
    [[nodiscard]] bool begun() const { return blockCount_ > 0; }

    /// Counts what the codes of a block hide of some suns; null: nothing. Fastest block by block.
    void add(std::size_t blockIndex, bool swapped, const HorizonCode* codes, std::span<const SunChange> suns);

    /// Adds steps to one cell of a block: 16 x row + column.
    void add(std::size_t blockIndex, std::size_t cell, std::uint32_t steps);

    /// Adds all to the steps of a tile, one a number.
    void addTo(const ReceiverBlocks& blocks, std::span<std::uint32_t> steps);

private:
    void moveTo(std::size_t blockIndex, bool swapped);

    std::size_t blockCount_ = 0, at_ = 0;
    bool atSwapped_ = false;
    std::vector<std::uint32_t> rows_, columns_;  // of codes row by row, and of swapped ones; empty: none
    std::optional<ShortSums<ReceiverBlocks::cells>> short_;  // of the blockIndex at hand
};

}  // namespace noonmark
