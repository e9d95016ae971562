#pragma once

#include <vector>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/cache/changed_receivers.h"
#include "core/engines/horizon/cache/occluder_cache.h"
#include "core/engines/horizon/cache/shaded_blocks.h"
#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"
#include "core/engines/horizon/sweep/block_sweep.h"

namespace noonmark {

/// The changes in a tile, in the order of its blocks.
struct TileEdit {
    const WallCache& walls;  ///< of the city after the change
    const WallChange& change;
    const ReceiverBlocks& blocks;  ///< after the change; all cells numbered
    const CachedCells& known;
    const BlockGrounds& grounds;
    const OverhangTile& overhangs;  ///< empty if there are no overhangs, before or after the change
    const ChangedReceivers& cells;  ///< codes of unknown cells are undefined
    bool undoesLast;                ///< the bins' pages are without the removed buildings
    bool level;                     ///< all receivers are at one level, so bins may have pages
    bool isOverhanging;  ///< there are overhangs, before or after the change, so code changes are needed
    int columns;         ///< of the grid
    double cellM;
    const std::stop_token& stop;
};

/// A horizon that changed.
struct CodeChange {
    std::uint32_t number;
    HorizonCode before, after;
};

/// Updates the horizons of one azimuth after a change of the city. First the horizons of each affected block
/// are restored to those without the buildings of the last change. If the block has a page (BaselineCodes),
/// they are taken from it. Otherwise a removed building determined a horizon only where it alone gives the
/// same code; those horizons, and unknown ones, are recomputed from all remaining occluders. Then the added
/// buildings raise the horizons. The codes equal those of a complete sweep, bit for bit. One per thread.
class BinEdit {
public:
    /// Adds to `steps` how many more of the suns the horizons of receivers hide; for new receivers, all
    /// hidden suns. If there are overhangs, returns the code changes of receivers, each number once; valid
    /// until the next call. Incomplete if stopped.
    std::span<const CodeChange> run(const TileEdit& edit, glm::dvec2 away, CachedBin& bin,
                                    std::span<const CountChange> suns, TileSteps& steps);

private:
    struct Lost {
        std::size_t block;
        ReceiverBlocks::Masks masks;  // of its rows (columns if swapped)
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
    std::span<const CountChange> suns_;
    TileSteps* steps_ = nullptr;
    glm::dvec2 away_{};
    ShadowAxes axes_{{0, 1}};
    BlockSweep removedSweep_, addedSweep_, allSweep_;
    ShadedBlocks removed_, added_;
    BlockMarks marks_;
    std::vector<std::size_t> blocks_;  // blocks to be examined
    std::vector<Lost> lost_;
    std::vector<StandingPrism> prisms_;
    std::vector<CodeChange> changes_;
    BlockCodes turned_;
};

}  // namespace noonmark
