#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/cache/counted_period.h"
#include "core/engines/horizon/cache/gap_edit.h"
#include "core/engines/horizon/cache/tile_count.h"
#include "core/engines/horizon/cache/wall_cache.h"
#include "core/engines/horizon/sweep/tile_sweep.h"

namespace noonmark {

/// The horizons of a tile, kept while dates, hours and buildings change.
class CachedTile {
public:
    CachedTile(const Receivers& receivers, const TileBox& box, std::size_t bins);
    CachedTile(CachedTile&&) noexcept;
    CachedTile& operator=(CachedTile&&) noexcept;
    ~CachedTile();

    [[nodiscard]] const ReceiverBlocks& blocks() const { return blocks_; }
    [[nodiscard]] std::size_t bytes() const;
    void drop();

    /// Sweeps the bins that are not there or do not reach low enough, and counts; of bins whose suns are
    /// those of the period before nothing. Returns how many it swept. `progress` hears of each bin.
    std::size_t retime(const Receivers& receivers, const WallCache& walls, const BinnedSun& binned,
                       Progress& progress, const std::stop_token& stop);

    /// After the city changed: buildings that went and came, `cells` that have become receivers or none, or
    /// lie at another height. Only horizons that may change are looked at. After a stop the tile is empty.
    void change(const Receivers& receivers, std::span<const std::uint32_t> cells, const WallCache& walls,
                const WallChange& change, CountedPeriod& period, double binDeg, const std::stop_token& stop);

    /// Forgets what horizons are without the buildings that came last: these take longer to go, then.
    void dropPages();

    /// Writes the gross minutes that are out of date.
    void writeGross(ShadowField& field, const std::stop_token& stop);

    /// Writes the longest runs that are out of date.
    void writeRuns(const BinnedSun& binned, const RunCount& count, ShadowField& field,
                   const std::stop_token& stop);

private:
    struct Sweeping;  // what the threads share while bins are swept
    struct Editing;   // or changed
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
    bool paged_ = false;  // the bins' pages are without the buildings that came last
    BlockGrounds grounds_;
    OverhangTile overhangs_;       // empty before anything hangs
    std::vector<CachedBin> bins_;  // by number
    TileCount count_;
    std::unique_ptr<EditMemory> memory_;  // kept from one change to the next
};

}  // namespace noonmark
