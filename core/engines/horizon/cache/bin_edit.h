#pragma once

#include <vector>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/cache/changed_receivers.h"
#include "core/engines/horizon/cache/shaded_blocks.h"
#include "core/engines/horizon/cache/wall_cache.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/counting/tile_steps.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"
#include "core/engines/horizon/sweep/block_sweep.h"

namespace noonmark {

/// What changed in a tile, in the blocks' order.
struct TileEdit {
    const WallCache& walls;  ///< of the city as it is now
    const WallChange& change;
    const ReceiverBlocks& blocks;  ///< as they are now, all cells numbered
    const CachedCells& known;
    const BlockGrounds& grounds;
    const OverhangTile& overhangs;  ///< nothing where nothing hangs nor hung
    const ChangedReceivers& cells;  ///< codes of unknown ones say nothing
    bool undoesLast;                ///< the pages of the bins are without what was removed
    bool level;                     ///< all receivers lie on one level: bins may have pages
    bool isOverhanging;             ///< something does or did: changes are asked for
    int columns;                    ///< of the grid
    double cellM;
    const std::stop_token& stop;
};

/// A horizon that is another now.
struct CodeChange {
    std::uint32_t number;
    HorizonCode before, after;
};

/// Brings the horizons of one azimuth up to date. In each block horizons are brought back to what they are
/// without what came last: they are kept (BaselineCodes), or else what is gone made a horizon just where it
/// alone gives the same code, and there, and where nothing is known, it is found again from all that stands.
/// Then what is new raises them. The codes are those of a sweep of the whole, bit for bit. One for each
/// thread.
class BinEdit {
public:
    /// Adds to `steps` how many of the suns more the horizons of receivers hide; of new ones all. Returns,
    /// where something hangs, what changed of receivers, of each number once; valid until the next call. Less
    /// once stopped.
    std::span<const CodeChange> run(const TileEdit& edit, glm::dvec2 away, CachedBin& bin,
                                    std::span<const SunChange> suns, TileSteps& steps);

private:
    struct Lost {
        std::size_t block;
        ReceiverBlocks::Masks masks;  // of its lines
    };
    void begin(const TileEdit& edit, ShadedBlocks& shaded, BlockSweep& sweep, const WallSet& set);
    void findBlocks(const TileEdit& edit);
    void look(const TileEdit& edit, std::size_t block);
    void addLost(const TileEdit& edit, Lost& lost);
    void leaveOutRaised(const TileEdit& edit, std::size_t block, const HorizonCode* now,
                        ReceiverBlocks::Masks& masks);
    void recompute(const TileEdit& edit);
    void recompute(const TileEdit& edit, const Lost& lost);
    void raise(const TileEdit& edit, std::size_t block, const BlockCodes* found);
    const HorizonCode* comingCodes(const TileEdit& edit, std::size_t block, const HorizonCode* base);
    HorizonCode lowestIn(const TileEdit& edit, std::size_t block, const HorizonCode* base);
    void prefetch(const TileEdit& edit, std::size_t block) const;
    void write(const TileEdit& edit, std::size_t block, const BlockCodes& codes);
    void count(const TileEdit& edit, std::size_t block, const BlockCodes& codes,
               const ReceiverBlocks::Masks& differ);

    CachedBin* bin_ = nullptr;
    std::span<const SunChange> suns_;
    TileSteps* steps_ = nullptr;
    glm::dvec2 away_{};
    ShadowAxes axes_{{0, 1}};
    BlockSweep removedSweep_, addedSweep_, allSweep_;
    ShadedBlocks removed_, added_;
    BlockMarks marks_;
    std::vector<std::size_t> blocks_;  // to be looked at
    std::vector<Lost> lost_;
    std::vector<StandingPrism> prisms_;
    std::vector<CodeChange> changes_;
    BlockCodes turned_;
};

}  // namespace noonmark
