#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/kept_bin.h"
#include "core/accumulate/horizon/period_count.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// Steps to be added to the sums of a tile, modulo 2^32; and which parts of 64 numbers they touch.
struct TileSteps {
    std::vector<std::uint32_t> more;  ///< one a number
    std::vector<std::uint8_t> parts;

    explicit TileSteps(const ReceiverBlocks& blocks) : more(blocks.numbers()), parts(partsOf(blocks)) {}
    void add(std::uint32_t number, std::uint32_t steps) {
        more[number] += steps;
        parts[number / lanesARun] = 1;
    }
};

/// The steps hidden in a tile in the period at hand, and what of the field is out of date.
class TileCount {
public:
    /// Counts a period; of bins whose suns are those of the period before nothing. `bins`: by number, those
    /// of the period are there. After a stop all is to be counted.
    void retime(const ReceiverBlocks& blocks, std::span<const KeptBin> bins, const BinnedSun& binned,
                const std::stop_token& stop);

    /// These count from nothing.
    void beginNew(const ReceiverBlocks& blocks, std::span<const std::uint32_t> numbers);
    void take(const TileSteps& steps);

    /// Writes the gross minutes that are out of date.
    void writeGross(const ReceiverBlocks& blocks, ShadowField& field, const std::stop_token& stop);

    /// Writes the longest runs that are out of date.
    void writeRuns(const ReceiverBlocks& blocks, std::span<const KeptBin> bins, const BinnedSun& binned,
                   const PeriodCount& count, ShadowField& field, const std::stop_token& stop);

private:
    struct BinTable {
        std::uint32_t number;
        HiddenSuns hidden;
    };
    std::vector<BinTable> tablesFor(const ReceiverBlocks& blocks, std::size_t bins, const BinnedSun& binned);
    void addHidden(const ReceiverBlocks& blocks, std::span<const KeptBin> bins,
                   const std::vector<BinTable>& tables, const std::stop_token& stop);
    void addGaps(const KeptBin& bin, const HiddenSuns& hidden, std::size_t first, std::size_t end);
    void allOld(const ReceiverBlocks& blocks);

    std::vector<std::uint32_t> hidden_;                  // one a number
    std::vector<std::vector<HorizonCode>> suns_;         // that were counted; by bin number
    std::vector<std::uint8_t> grossIsOld_, runsAreOld_;  // one for each 64 numbers
};

}  // namespace noonmark
