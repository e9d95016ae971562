#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/accumulate/horizon/receiver_blocks.h"
#include "core/accumulate/horizon/short_sums.h"
#include "core/accumulate/horizon/sun_change.h"

namespace noonmark {

/// Steps hidden in the squares of a tile, counted from codes line by line as a sweep gives them: no horizon
/// need be kept. 1 kB a square, twice where shadows run along both sides of the grid. For one thread.
class SquareSums {
public:
    /// No steps.
    void begin(std::size_t squares);
    [[nodiscard]] bool begun() const { return squares_ > 0; }

    /// Counts what the codes of a square hide of some suns; null: nothing. Fastest square by square.
    void add(std::size_t square, bool swapped, const HorizonCode* codes, std::span<const SunChange> suns);

    /// Adds steps to one cell of a square: 16 x row + column.
    void add(std::size_t square, std::size_t cell, std::uint32_t steps);

    /// Adds all to the steps of a tile, one a number.
    void addTo(const ReceiverBlocks& blocks, std::span<std::uint32_t> steps);

private:
    void moveTo(std::size_t square, bool swapped);

    std::size_t squares_ = 0, at_ = 0;
    bool atSwapped_ = false;
    std::vector<std::uint32_t> rows_, columns_;  // of codes row by row, and of swapped ones; empty: none
    std::optional<ShortSums<ReceiverBlocks::cells>> short_;  // of the square at hand
};

}  // namespace noonmark
