#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/cache/cached_bin.h"
#include "core/engines/horizon/cache/occluder_cache.h"
#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"
#include "core/engines/horizon/sweep/block_sweep.h"

namespace noonmark {

/// Marks blocks as visited. Reuses its memory.
class BlockMarks {
public:
    void begin(std::size_t blocks);
    /// Marks the block and returns whether it was not marked before.
    bool mark(std::size_t block) {
        const bool first = marks_[block] != turn_;
        marks_[block] = turn_;
        return first;
    }

private:
    std::vector<std::uint32_t> marks_;
    std::uint32_t turn_ = 0;
};

/// The area that some obstacles may shade, at one azimuth.
class ShadedBlocks {
public:
    /// `lowestTan`: of the bin's suns. `cellM`: metres per cell.
    void begin(const WallSet& set, const ShadowAxes& axes, double lowestTan, double cellM);

    /// Appends the blocks of a tile that may lie in the shadows and are not marked yet, and marks them.
    void find(const ReceiverBlocks& blocks, const ShadowAxes& axes, BlockMarks& marks,
              std::vector<std::size_t>& found) const;

    /// Whether an obstacle may give a cell of the block, on level ground, a horizon above this code. The
    /// margin exceeds rounding.
    [[nodiscard]] bool mayRaise(const ReceiverBlocks::Block& block, const ShadowAxes& axes,
                                HorizonCode code) const;

    [[nodiscard]] bool empty() const { return shadows_.empty(); }
    /// Extent of the obstacles in q, and of the tile along.
    [[nodiscard]] ShadowExtent extentIn(const ShadowExtent& tile) const;

private:
    struct Shadow {
        ShadowExtent extent;
        double foot;  ///< highest `along` of the obstacle
        double rise;  ///< scaled so that rise / (distance in `along`) is the tangent of the horizon
    };
    void find(const Shadow& shadow, const ReceiverBlocks& blocks, const ShadowAxes& axes, BlockMarks& marks,
              std::vector<std::size_t>& found) const;

    std::vector<Shadow> shadows_;
};

/// The cells of a tile whose horizons are cached: its receivers, and cells that were receivers until the
/// buildings added by the last change covered them.
class CachedCells {
public:
    /// Initially the receivers of `blocks`, all of whose cells have numbers.
    explicit CachedCells(const ReceiverBlocks& blocks) {
        for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
            rows_.push_back(blocks.masks(i, false));
            columns_.push_back(blocks.masks(i, true));
        }
    }

    [[nodiscard]] const ReceiverBlocks::Masks& masks(std::size_t block, bool swapped) const {
        return swapped ? columns_[block] : rows_[block];
    }
    [[nodiscard]] bool has(const ReceiverBlocks::CellSlot& slot) const {
        return (rows_[slot.block][std::size_t(slot.y)] >> unsigned(slot.x) & 1U) != 0;
    }
    void add(const ReceiverBlocks::CellSlot& slot) {
        rows_[slot.block][std::size_t(slot.y)] |= std::uint16_t(1U << unsigned(slot.x));
        columns_[slot.block][std::size_t(slot.x)] |= std::uint16_t(1U << unsigned(slot.y));
    }

private:
    std::vector<ReceiverBlocks::Masks> rows_, columns_;
};

/// Cells of the grid, ascending, that became receivers, ceased to be receivers or lie at another height.
/// Heights are not compared if the ground is level in only one of the two.
std::vector<std::uint32_t> findChangedReceivers(const Receivers& before, const Receivers& now);

/// The effect of a change of the city on the receivers of a tile whose cells all have numbers.
struct ChangedReceivers {
    /// For each block, cells that became receivers or lie at another height.
    std::vector<ReceiverBlocks::Masks> newRows;
    /// The subset whose horizons are not known.
    std::vector<ReceiverBlocks::Masks> unknownRows, unknownColumns;
    std::vector<std::size_t> newBlocks;                    ///< blocks with new cells
    std::vector<std::uint32_t> newNumbers, formerNumbers;  ///< of new and of former receivers
};

/// Updates `blocks` to the current receivers; new receivers become known. `cells`: from
/// findChangedReceivers(), may include cells of other tiles.
ChangedReceivers update(ReceiverBlocks& blocks, CachedCells& known, const Receivers& now,
                        std::span<const std::uint32_t> cells);

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
    const HorizonCode* addedCodes(const TileEdit& edit, std::size_t block, const HorizonCode* base);
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

/// A receiver whose gaps may have changed or may hide other suns.
struct GapChange {
    std::uint32_t number;
    std::uint32_t added;  ///< how many more suns they hide above the horizon, modulo 2^32
};

/// Updates the gaps of one azimuth after its horizons have been updated. Gaps are recomputed for new
/// receivers, where the horizon fell (gaps below it are not cached) and where overhangs were removed or
/// added. Elsewhere they stay, but a horizon that rose covers more of them. One per thread.
class GapEdit {
public:
    /// The cached data of one azimuth.
    struct Bin {
        glm::dvec2 away;
        HorizonCode lowest;
        std::span<const HorizonCode> codes;   ///< after the change
        std::span<const CodeChange> changes;  ///< how the codes changed
        const HiddenSuns* hidden;             ///< of the period; null: it does not visit the bin
    };

    /// Returns the receivers whose gaps may have changed, possibly with two entries for one number; for new
    /// receivers all hidden suns. Valid until the next call. Empty if the period does not visit the bin.
    std::span<const GapChange> run(const TileEdit& edit, const Bin& bin, std::vector<Gap>& gaps);

private:
    enum State : std::uint8_t {
        untouched = 0,
        touched = 1,  ///< the horizon changed
        stale = 2,    ///< gaps to be recomputed
        fresh = 4,    ///< a new receiver
        removed = 8   ///< no longer a receiver
    };

    void begin(const TileEdit& edit, const Bin& bin);
    void mark(std::uint32_t number, State state);
    void markHit(const TileEdit& edit, const Bin& bin, std::span<const OverhangShapes> shapes);
    [[nodiscard]] static OverhangView viewOf(const TileEdit& edit, const Bin& bin,
                                             std::span<const OverhangShapes* const> shapes);
    void add(const Bin& bin, std::span<const Gap> gaps, bool before);
    void recompute(const TileEdit& edit, const Bin& bin);
    using FoundGap = std::vector<Gap>::const_iterator;
    void findBlocks();
    void rewrite(const Bin& bin, std::span<const Gap> gaps, std::uint32_t block, FoundGap& found);
    void merge(std::span<const Gap> gaps, std::uint32_t end, FoundGap& found);
    void replace(std::vector<Gap>& gaps);
    void clear();

    OverhangSweep sweep_;
    std::vector<std::uint8_t> states_;    // one per number
    std::vector<HorizonCode> before_;     // previous codes, for touched numbers
    std::vector<HorizonCode> horizons_;   // blind except where gaps are recomputed
    std::vector<std::uint32_t> numbers_;  // numbers that are not untouched
    OverhangList list_;
    std::vector<Gap> found_, merged_, rest_;
    std::vector<std::uint32_t> blocks_;  // blocks with numbers that are not untouched; ascending
    /// The gaps [first, end) of a block, and the end of their replacement in merged_.
    struct Rewritten {
        std::size_t first, end, mergedEnd;
    };
    std::vector<Rewritten> rewritten_;
    std::vector<GapChange> changes_;
};

}  // namespace noonmark
