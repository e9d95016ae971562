#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/counting/tile_steps.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The steps hidden in a tile in the period at hand, and what of the field is out of date.
class TileCount {
public:
    /// Counts a period; of bins whose suns are those of the period before nothing, of the others the suns
    /// that came and went. `bins`: by number, those of the period are there. After a stop all is to be
    /// counted.
    void retime(const ReceiverBlocks& blocks, std::span<const CachedBin> bins, const BinnedSun& binned,
                const std::stop_token& stop);

    /// These count from nothing.
    void beginNew(const ReceiverBlocks& blocks, std::span<const std::uint32_t> numbers);
    /// Adds steps to the sums, and clears them.
    void take(TileSteps& steps);

    /// Writes the gross minutes that are out of date.
    void writeGross(const ReceiverBlocks& blocks, ShadowField& field, const std::stop_token& stop);

    /// Writes the longest runs that are out of date.
    void writeRuns(const ReceiverBlocks& blocks, std::span<const CachedBin> bins, const BinnedSun& binned,
                   const RunCount& count, ShadowField& field, const std::stop_token& stop);

private:
    using Suns = std::vector<HorizonCode>;
    struct BinChange {
        std::uint32_t number;
        std::vector<SunChange> changes;
        std::vector<HiddenSuns> hidden;  ///< the same for gaps, where the bin has any
    };
    std::vector<BinChange> changesFor(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                                      const BinnedSun& binned);
    void addHidden(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                   const std::vector<BinChange>& changes, const std::stop_token& stop);
    void addGaps(const CachedBin& bin, const HiddenSuns& hidden, std::size_t first, std::size_t end);
    void allOld(const ReceiverBlocks& blocks);

    std::vector<std::uint32_t> hidden_;                  // one a number
    std::vector<Suns> suns_;                             // that were counted; by bin number
    std::vector<std::uint8_t> grossIsOld_, runsAreOld_;  // one for each 64 numbers
};

}  // namespace noonmark
