#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/cache/occluder_cache.h"
#include "core/engines/horizon/cache/tile_edit.h"
#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/sweep/tile_sweep.h"

namespace noonmark {

/// The steps hidden in a tile during the current period, and which parts of the field are out of date.
class TileCount {
public:
    /// Counts a period. Bins whose suns are those of the previous period are skipped; for others, only added
    /// and removed suns are counted. `bins`: by number; those of the period must be cached. After a stop, the
    /// next call counts everything.
    void computePeriod(const ReceiverBlocks& blocks, std::span<const CachedBin> bins, const BinnedSun& binned,
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

/// A period's bins by number: null or empty if the period does not visit the bin.
using HiddenByNumber = std::vector<const HiddenSuns*>;
using SunsByNumber = std::vector<std::vector<CountChange>>;  ///< changes from an empty period

/// A period prepared for counting with cached horizons. Data that not every count needs is created on first
/// use. Not thread-safe.
class CountedPeriod {
public:
    CountedPeriod(const SunSteps& sun, double binDeg);

    [[nodiscard]] const BinnedSun& binned() const { return binned_; }
    /// O(steps) on the first call.
    const RunCount& runs();
    /// The same tables in two forms, for looking up one horizon and for a row of them. `bins`: number of
    /// possible bin numbers. Some 0.05 ms per bin on the first call.
    const HiddenByNumber& hidden(std::size_t bins);
    const SunsByNumber& suns(std::size_t bins);

private:
    BinnedSun binned_;
    std::vector<TimedStep> steps_;  // empty after runs_ is created
    std::optional<RunCount> runs_;
    std::vector<std::optional<HiddenSuns>> tables_;  // one per bin
    HiddenByNumber hidden_;
    SunsByNumber suns_;
};

/// The horizons of a tile, cached while dates, hours and buildings change.
class CachedTile {
public:
    CachedTile(const Receivers& receivers, const TileBox& box, std::size_t bins);
    CachedTile(CachedTile&&) noexcept;
    CachedTile& operator=(CachedTile&&) noexcept;
    ~CachedTile();

    [[nodiscard]] const ReceiverBlocks& blocks() const { return blocks_; }
    [[nodiscard]] std::size_t bytes() const;
    void drop();

    /// Sweeps the bins that are not cached or do not reach low enough, and counts the period; bins whose suns
    /// are those of the previous period are not counted again. Returns the number of bins swept. `progress`
    /// is updated after each bin.
    std::size_t computePeriod(const Receivers& receivers, const WallCache& walls, const BinnedSun& binned,
                              Progress& progress, const std::stop_token& stop);

    /// Updates the tile after a change of the city: buildings were removed and added, and `cells` became
    /// receivers, ceased to be receivers or lie at another height. Only horizons that may change are
    /// examined. If stopped, the tile is empty afterwards.
    void change(const Receivers& receivers, std::span<const std::uint32_t> cells, const WallCache& walls,
                const WallChange& change, CountedPeriod& period, double binDeg, const std::stop_token& stop);

    /// Drops the horizons without the buildings of the last change, so removing these buildings takes longer.
    void dropPages();

    /// Updates gross minutes that are out of date.
    void writeGross(ShadowField& field, const std::stop_token& stop);

    /// Updates longest runs that are out of date.
    void writeRuns(const BinnedSun& binned, const RunCount& count, ShadowField& field,
                   const std::stop_token& stop);

private:
    struct Sweeping;  // shared by the threads while bins are swept
    struct Editing;   // shared by the threads while bins are changed
    struct EditMemory;
    std::size_t sweep(const Receivers& receivers, const WallCache& walls, const BinnedSun& binned,
                      Progress& progress, const std::stop_token& stop);
    void sweep(std::span<const AzimuthBin> missing, Sweeping& sweeping);
    void findGaps(CachedBin& cached, glm::dvec2 away, Sweeping& sweeping) const;
    void lookAtGround(const Receivers& receivers, const WallCache& walls, bool wasOverhanging);
    ChangedReceivers update(const Receivers& receivers, std::span<const std::uint32_t> cells,
                            bool undoesLast);
    void change(std::uint32_t number, Editing& editing);

    TileBox box_;
    ReceiverBlocks blocks_;
    CachedCells known_;
    bool paged_ = false;  // the bins' pages are without the buildings added by the last change
    BlockGrounds grounds_;
    OverhangTile overhangs_;       // empty until there are overhangs
    std::vector<CachedBin> bins_;  // by bin number
    TileCount count_;
    std::unique_ptr<EditMemory> memory_;  // reused from one change to the next
};

}  // namespace noonmark
