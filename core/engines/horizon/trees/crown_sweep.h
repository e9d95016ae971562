#pragma once

// The folder core/engines/horizon/trees weighs crowns within the horizon sweep. In this file, CrownSweep has
// the crowns and the suns of each bin in levels of altitude, CrownBatch adds the crowns before each block,
// and addCrownToBlock(), findVisibleLevels(), weighBlock(), findDark() and makeDarkSpan() are the inner
// loops. crown_runs.h counts longest runs.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/trees/crowns.h"

namespace noonmark {

/// The suns of a group of bins in levels of altitude, from the lowest up; those of a level are weighed
/// together, at the mean of their altitudes. Entries from `count` on are harmless.
struct CrownLevels {
    static constexpr std::size_t maximum = 16;  ///< a level is a bit
    std::size_t count = 0;
    alignas(64) float tan[maximum] = {}, perTan[maximum] = {},
                      secant[maximum] = {};     ///< of the altitude; 1 / tan
    alignas(64) float belowCode[maximum] = {};  ///< code of its highest sun + 1
    alignas(64) float perCode[maximum] = {};    ///< 1 / (belowCode - code of its lowest sun)
    alignas(64) float inLeaf[maximum] = {}, bare[maximum] =
                                                {};  ///< numbers of suns in and out of the leaf season
    HorizonCode meanCode[maximum] = {};              ///< of the mean altitude
    std::uint16_t weighed = 0;                       ///< levels that have suns, as bits
    [[nodiscard]] std::uint16_t all() const { return std::uint16_t((1U << count) - 1); }
    /// Spans of altitude for longest runs: below the mean of the lowest level, between those of neighbouring
    /// levels, and above that of the highest.
    [[nodiscard]] std::size_t spans() const { return count + 1; }
    [[nodiscard]] std::uint32_t spanOf(HorizonCode sun) const {
        std::uint32_t span = 0;
        while (span < count && sun >= meanCode[span]) ++span;
        return span;
    }
};

/// Where crowns take a share of the sun or more from one cell, at one azimuth. Bit i: dark at the mean of
/// level i. Where two neighbouring levels differ, the share is reached between them: the first four such
/// places follow from bit 16 on, 4 bits each, in sixteenths of the way; further ones count as the middle.
using DarkLevels = std::uint32_t;
inline constexpr unsigned firstChangeBit = 16, bitsOfChange = 4;

/// The suns of one bin and one set of steps (StepSets) in the levels of their group.
struct CrownLevelsOfSet {
    std::size_t set;
    CrownLevels levels;
};

/// A crown before a block. Its axis is `distance` along the azimuth from the block's first cell, towards the
/// sun, and `aside` across it; both change from row to row and from cell to cell. Metres.
struct CrownOnBlock {
    float distance, distancePerRow, distancePerCell;
    float aside, asidePerRow, asidePerCell;
    float bottomM, topM, radiusM;  ///< elevations above the datum of the cells
    float inLeafPerM, barePerM;    ///< optical depth
    CrownShape shape;
};

/// Ground of a block's cells above the datum.
struct CrownGround {
    const CacheLine<float>* rowsM = nullptr;  ///< null: all at the datum
    float lowestM = 0, highestM = 0;          ///< of the receivers
};

/// Optical depths before the cells of a block at each level, in and out of the leaf season, or, after
/// toShares(), the shares of the sun that crowns take. Those of a row and level that no crown has touched are
/// unspecified.
struct CrownDepths {
    static constexpr std::size_t side = ReceiverBlocks::side;
    std::uint16_t touched[side] = {};  ///< levels of each row, as bits
    alignas(64) float inLeaf[side][CrownLevels::maximum][side];
    alignas(64) float bare[side][CrownLevels::maximum][side];  ///< only at levels with suns out of season
};

/// Adds a crown at those levels of each row, as bits, at which its shadow may meet the row.
void addCrownToBlock(const CrownOnBlock& crown, const CrownLevels& levels, const CrownGround& ground,
                     const std::uint16_t* visible, CrownDepths& depths);

/// Turns the depths of some levels of each row, as bits, into shares: 1 - exp(-depth), within 5e-5.
void toShares(const CrownLevels& levels, const std::uint16_t* some, CrownDepths& depths);

/// For each row of a block the levels of which some receiver sees a sun, as bits.
void findVisibleLevels(const CrownLevels& levels, const HorizonCode* codes,
                       const ReceiverBlocks::Masks& receivers, std::uint16_t* visible);

/// Adds the steps that crowns take from a block's cells, of those that their horizons leave, times
/// `fractions`, at the levels that have suns: each sun counts by its share. A level that a horizon cuts
/// counts by the share of its codes. Sums are 16 a row; those of cells that are no receivers are of no use.
void weighBlock(const CrownLevels& levels, const CrownDepths& shares, const HorizonCode* codes,
                float fractions, std::int32_t* evergreen, std::int32_t* seasonal);

/// Finds for each cell of a block, 16 a row, where crowns take `share` of the sun or more; true if they do
/// somewhere. Shares between levels are those of a straight line. `computed`: the levels of each row whose
/// shares are known, as bits; the others count as the next lower one that is known, below the lowest as that
/// one; a change over such a gap lies in its last span. `bare`: at levels with suns out of season alone.
bool findDark(const CrownLevels& levels, const CrownDepths& shares, const std::uint16_t* computed,
              float share, DarkLevels* inLeaf, DarkLevels* bare, bool& anyBare);

/// The codes of 64 suns or horizons.
inline constexpr std::size_t lanesOfDark = 64;
/// Where suns are hidden within a span: those below `below`, and those above `above`.
struct DarkSpan {
    alignas(64) HorizonCode below[lanesOfDark], above[lanesOfDark];
};
/// What horizons and crowns hide of a span (CrownLevels::spans()). `dark`: of the 64 cells; the changes of a
/// span are taken off it, so that spans are asked for in ascending order.
void makeDarkSpan(const CrownLevels& levels, std::size_t span, const HorizonCode* horizons, DarkLevels* dark,
                  DarkSpan& made);

/// Steps of each set taken by crowns from each cell of a tile's blocks, in fractions of a step, so that sums
/// are the same in whatever order they are made. For one thread.
class CrownSums {
public:
    struct Block {
        alignas(64) std::int32_t evergreen[ReceiverBlocks::cells] = {};
        alignas(64) std::int32_t seasonal[ReceiverBlocks::cells] = {};
    };
    struct Steps {
        double evergreen = 0, seasonal = 0;
    };
    /// Memory of each set and block.
    static constexpr std::size_t bytesPerBlock = 2 * sizeof(Block);
    /// `steps`: of the period; a cell's sum is at most all of them.
    void begin(std::size_t sets, std::size_t blocks, std::size_t steps);
    [[nodiscard]] bool begun() const { return !blocks_.empty(); }
    void end() { blocks_.clear(); }
    [[nodiscard]] float fractions() const { return fractions_; }
    /// Sums row by row, column by column if swapped.
    [[nodiscard]] Block& at(std::size_t set, std::size_t block, bool swapped) {
        return blocks_[2 * (set * blocksOfSet_ + block) + (swapped ? 1 : 0)];
    }
    /// `cell`: row by row.
    [[nodiscard]] Steps steps(std::size_t set, std::size_t block, std::size_t cell) const;

private:
    float fractions_ = 1;
    std::size_t blocksOfSet_ = 0;
    std::vector<Block> blocks_;
};

/// The crowns and suns of a period. Neighbouring bins form groups, whose suns see crowns from one azimuth, as
/// crowns have no corners: what a crown takes earlier on one side it takes later on the other.
class CrownSweep {
public:
    /// At most so many levels a group.
    static constexpr std::size_t maxLevels = 12;
    static_assert(maxLevels <= CrownLevels::maximum);
    /// A group's width, from its first sun to its last, unless a bin is wider. Longest runs begin and end at
    /// the azimuth of their group.
    static constexpr double widestGroupDeg(ShadowCounts counts) {
        return counts == ShadowCounts::grossAndRuns ? 0.5 : 2;
    }

    /// `scene`, `binned` and `sets` are of the same steps; `datumM`: local z from which heights count.
    CrownSweep(const CrownScene& scene, const BinnedSun& binned, const StepSets& sets, const Grid& grid,
               double datumM, double groupDeg);

    /// Where crowns stand: metres from the grid's south-western corner.
    [[nodiscard]] std::span<const glm::dvec2> places() const { return places_; }
    /// The crowns, but for where they stand before a block.
    [[nodiscard]] std::span<const CrownOnBlock> crowns() const { return crowns_; }
    [[nodiscard]] std::size_t bins() const { return groupOfBin_.size(); }
    [[nodiscard]] std::size_t groupOf(std::size_t bin) const { return groupOfBin_[bin]; }
    /// Of the bin's group.
    [[nodiscard]] const CrownLevels& levels(std::size_t bin) const {
        return groups_[groupOfBin_[bin]].levels;
    }
    /// The bin's own suns by set: those that have some.
    [[nodiscard]] std::span<const CrownLevelsOfSet> levelsOfSets(std::size_t bin) const {
        return levelsOfSets_[bin];
    }
    [[nodiscard]] std::size_t sets() const { return sets_; }
    /// The direction in which shadows fall at a group.
    [[nodiscard]] glm::dvec2 away(std::size_t group) const { return groups_[group].away; }
    [[nodiscard]] double cellM() const { return cellM_; }
    [[nodiscard]] float widestM() const { return widestM_; }    ///< the largest radius
    [[nodiscard]] float highestM() const { return highestM_; }  ///< the highest top above the datum
    [[nodiscard]] std::size_t steps() const { return steps_; }

private:
    struct Group {
        CrownLevels levels;
        glm::dvec2 away;
    };
    std::vector<glm::dvec2> places_;
    std::vector<CrownOnBlock> crowns_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> groupOfBin_;
    std::vector<std::vector<CrownLevelsOfSet>> levelsOfSets_;  // of each bin
    double cellM_;
    float widestM_ = 0, highestM_ = 0;
    std::size_t steps_, sets_;
};

class CrownMarks;

/// The crowns at one bin after the other. What they take from a block is computed once for the bins of a
/// group that follow each other there. Reuses its memory; one per thread.
class CrownBatch {
public:
    /// Selects the bins [first, end).
    void begin(const CrownSweep& sweep, std::size_t first, std::size_t end);

    /// An overhang hides the suns of these codes, [low, high), from a cell of the block that add() is called
    /// for next. `cell`: row by row.
    void hide(int cell, HorizonCode low, HorizonCode high) {
        gaps_.push_back({std::size_t(cell), low, high});
    }

    /// Adds what crowns take from a block's cells at a bin. `codes`: the cells' horizons, as from BlockSweep;
    /// null: all level. `marks`: null if longest runs are not counted.
    void add(std::size_t bin, std::size_t blockIndex, const ReceiverBlocks& blocks, const HorizonCode* codes,
             bool swapped, const BlockGround& ground, CrownSums& sums, CrownMarks* marks);

private:
    /// A crown in the axes of one azimuth, metres.
    struct PlacedCrown {
        float aside, ahead;  ///< across the azimuth, and along it towards the sun, from the grid's corner
        std::uint32_t crown;
    };
    /// Those of one group in squares: bands across the azimuth, in each from the farthest from the sun on.
    struct Squares {
        float lowestAside = 0, lowestAhead = 0;
        float perM = 0;  ///< 1 / side
        int bands = 0, inBand = 0;
        std::vector<std::uint32_t> first;  // of each square, and the end
        std::vector<PlacedCrown> crowns;
        [[nodiscard]] std::size_t at(const PlacedCrown& crown) const;
        [[nodiscard]] std::span<const PlacedCrown> find(int band, float nearest, float farthest) const;
    };
    struct HiddenGap {
        std::size_t cell;
        HorizonCode low, high;
    };
    using RowLevels = std::array<std::uint16_t, ReceiverBlocks::side>;  // of each row, as bits
    /// A block at one azimuth.
    struct BlockView {
        const CrownLevels* levels = nullptr;
        float aside = 0, ahead = 0;  // of its first cell, metres
        float asidePerRow = 0, aheadPerRow = 0, asidePerCell = 0, aheadPerCell = 0;
        float lowAside = 0, highAside = 0, lowAhead = 0, highAhead = 0;  // of its cells
        CrownGround ground;
    };
    /// Levels that are to be computed of each row.
    struct Wanted {
        RowLevels levels{};
        float lowestTan = 0;
    };

    void place(const CrownSweep& sweep, std::size_t group, Squares& squares);
    void beginBlock(std::size_t bin, std::size_t blockIndex, const ReceiverBlocks& blocks, bool swapped,
                    const BlockGround& ground);
    [[nodiscard]] BlockView viewOf(std::size_t bin, const ReceiverBlocks::Block& block, bool swapped) const;
    static void setGround(BlockView& view, const BlockGround& ground, const ReceiverBlocks::Masks& receivers);
    [[nodiscard]] bool findWanted(const HorizonCode* codes, const ReceiverBlocks::Masks& receivers,
                                  Wanted& wanted) const;
    void computeShares(const Wanted& wanted);
    void addCrowns(const Squares& squares, const Wanted& wanted);
    void addCrown(const PlacedCrown& placed, const Wanted& wanted);
    void mark(std::size_t bin, std::size_t blockIndex, bool swapped, CrownMarks& marks) const;
    void takeGap(const HiddenGap& gap, const CrownLevels& levels, bool swapped, float fractions,
                 CrownSums::Block& sums) const;

    const CrownSweep* sweep_ = nullptr;
    std::size_t firstGroup_ = 0;
    std::vector<Squares> squares_;
    std::vector<PlacedCrown> unsorted_;
    std::vector<HiddenGap> gaps_;
    // Of the group and the block of the last call.
    static constexpr std::size_t none = std::size_t(-1);
    std::size_t group_ = none, block_ = none;
    BlockView view_;
    RowLevels computed_{};
    CrownDepths shares_;
};

/// What crowns take of the sun that buildings leave, in one sweep for all sets. `crowns`: with one; of the
/// same receivers and steps. Costs as a sweep of gross shadow with trees
/// (core/engines/horizon/horizon_sweep.cpp), and some half of it more for months. Where trees have leaf days
/// of their own, a sweep for each phase (LeafPhases). `counts`: whether longest runs are counted, too.
Result<TakenBySet> sweepCrowns(const City& city, const CrownScene& crowns, const Receivers& receivers,
                               const SunSteps& sun, const StepSets& sets, Progress& progress,
                               const std::stop_token& stop, ShadowCounts counts = ShadowCounts::gross);

/// Whether rays weigh crowns sooner than a sweep for sets of these steps: whatever the receivers, since those
/// of a tile are measured as those of the whole.
bool areRaysQuicker(const SunSteps& sun);

}  // namespace noonmark
