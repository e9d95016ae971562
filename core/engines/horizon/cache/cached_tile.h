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
    std::size_t retime(const Receivers& receivers, const WallCache& walls, const BinnedSun& binned,
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
