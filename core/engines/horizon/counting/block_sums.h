#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Counts hidden steps per block of a tile directly from the codes of a sweep, so that horizons need not be
/// stored. 1 kB per block, twice that if shadows run along both grid axes. For one thread.
class BlockSums {
public:
    /// Resets all counts to zero.
    void begin(std::size_t blockCount);
    [[nodiscard]] bool begun() const { return blockCount_ > 0; }

    /// Counts the suns that the codes of a block hide; null: none. Fastest if called block by block.
    void add(std::size_t blockIndex, bool swapped, const HorizonCode* codes,
             std::span<const CountChange> suns);

    /// Adds steps to one cell of a block: 16 x row + column.
    void add(std::size_t blockIndex, std::size_t cell, std::uint32_t steps);

    /// Adds all counts to the steps of a tile, one per number.
    void addTo(const ReceiverBlocks& blocks, std::span<std::uint32_t> steps);

private:
    void moveTo(std::size_t blockIndex, bool swapped);

    std::size_t blockCount_ = 0, at_ = 0;
    bool atSwapped_ = false;
    std::vector<std::uint32_t> rows_, columns_;  // counts from unswapped and from swapped codes; empty: none
    std::optional<ShortSums<ReceiverBlocks::cells>> short_;  // of the current block
};

}  // namespace noonmark
