#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The steps hidden in a tile during the current period, and which parts of the field are out of date.
class TileCount {
public:
    /// Counts a period. Bins whose suns are those of the previous period are skipped; for others, only added
    /// and removed suns are counted. `bins`: by number; those of the period must be cached. After a stop, the
    /// next call counts everything.
    void retime(const ReceiverBlocks& blocks, std::span<const CachedBin> bins, const BinnedSun& binned,
                const std::stop_token& stop);

    /// Resets the sums of these numbers to zero.
    void beginNew(const ReceiverBlocks& blocks, std::span<const std::uint32_t> numbers);
    /// Adds `steps` to the sums and clears `steps`.
    void take(TileSteps& steps);

    /// Updates gross minutes that are out of date.
    void writeGross(const ReceiverBlocks& blocks, ShadowField& field, const std::stop_token& stop);

    /// Updates longest runs that are out of date.
    void writeRuns(const ReceiverBlocks& blocks, std::span<const CachedBin> bins, const BinnedSun& binned,
                   const RunCount& count, ShadowField& field, const std::stop_token& stop);

private:
    using Suns = std::vector<HorizonCode>;
    struct BinChange {
        std::uint32_t number;
        std::vector<CountChange> changes;
        std::vector<HiddenSuns> hidden;  ///< the same for gaps, if the bin has any
    };
    std::vector<BinChange> changesFor(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                                      const BinnedSun& binned);
    void addHidden(const ReceiverBlocks& blocks, std::span<const CachedBin> bins,
                   const std::vector<BinChange>& changes, const std::stop_token& stop);
    void addGaps(const CachedBin& bin, const HiddenSuns& hidden, std::size_t first, std::size_t end);
    void allOld(const ReceiverBlocks& blocks);

    std::vector<std::uint32_t> hidden_;                  // one per number
    std::vector<Suns> suns_;                             // suns included in the sums; by bin number
    std::vector<std::uint8_t> grossIsOld_, runsAreOld_;  // one per 64 numbers
};

}  // namespace noonmark
