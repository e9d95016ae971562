#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/longest_runs.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Accumulates sums in 16 bits for as long as they cannot overflow, so that they stay in the first-level
/// cache through all bins. `lines`: ranges of numbers from `first` on, up to `maxNumbers` in total; call
/// flush() before reading `all`. `lines` and `all` must outlive it.
template <std::size_t maxNumbers>
class ShortSums {
public:
    ShortSums(std::size_t first, std::span<const NumberRange> lines, std::uint32_t* all)
        : first_(first), lines_(lines), all_(all) {}

    void add(const CountChange& change, const HorizonCode* horizons) {
        constexpr int maxShort = std::numeric_limits<std::int16_t>::max();
        if (maximum_ + change.maximum() > maxShort) flush();
        maximum_ += change.maximum();
        for (const auto& [first, end] : lines_)
            change.addTo(horizons + first, end - first, sums_.data() + (first - first_));
    }

    void flush() {
        for (const auto& [first, end] : lines_)
            for (std::size_t i = first; i < end; ++i) all_[i] += std::uint32_t(int(sums_[i - first_]));
        sums_.fill(0);
        maximum_ = 0;
    }

private:
    std::size_t first_;
    std::span<const NumberRange> lines_;
    std::uint32_t* all_;
    int maximum_ = 0;
    std::array<std::int16_t, maxNumbers> sums_{};
};

/// For the numbers of a tile: half of a first-level cache.
inline constexpr std::size_t maxShortNumbers = 16'384;
using TileShortSums = ShortSums<maxShortNumbers>;

/// Steps to be added to the sums of a tile, modulo 2^32, and the parts of 64 numbers that are affected.
struct TileSteps {
    std::vector<std::uint32_t> more;  ///< one per number
    std::vector<std::uint8_t> parts;

    explicit TileSteps(std::size_t numbers)
        : more(numbers), parts((numbers + lanesPerPart - 1) / lanesPerPart) {}
    void add(std::uint32_t number, std::uint32_t steps) {
        more[number] += steps;
        parts[number / lanesPerPart] = 1;
    }
};

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
