#pragma once

// The folder core/engines/horizon/trees weighs crowns within the horizon sweep. In this file, CrownSweep has
// the crowns and the suns of each bin in levels of altitude, CrownBatch adds the crowns before each block,
// and addCrownToRow() and weighRow() are the inner loops.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/trees/crowns.h"

namespace noonmark {

/// Suns of a bin that are weighed together, at the mean tangent of their altitudes.
struct CrownLevel {
    float tan = 0, secant = 1;   ///< of the altitude
    float belowCode = 0;         ///< code of its highest sun + 1
    float perCode = 1;           ///< 1 / (belowCode - code of its lowest sun)
    float inLeaf = 0, bare = 0;  ///< numbers of suns in and out of the leaf season
};

/// A crown before a row of 16 cells, as a quadric cut by two levels. With x from its axis away from the cell,
/// u aside and p the ray's height over the pivot there: inside where a (x2 + u2) + q (p + tan x)2 + c <= 0.
struct CrownOnRow {
    float distance,
        distanceStep;        ///< along the azimuth from the first cell to the axis; from cell to cell, m
    float aside, asideStep;  ///< across it, m
    float a, q, c;
    float pivotM, bottomM, topM;     ///< above the datum of the cells
    float inLeafPerM, barePerM;      ///< optical depth
    const float* groundM = nullptr;  ///< of the 16 cells above the datum; null: 0
};

/// Adds the crown's optical depth at some levels: to [level][cell], 16 floats a level, from the first level
/// of the span on.
void addCrownToRow(const CrownOnRow& crown, std::span<const CrownLevel> levels, float* inLeaf, float* bare);

/// Steps that crowns take from cells at some levels, of those that the cells' horizons leave: each sun counts
/// 1 - exp(-optical depth). A level that a horizon cuts counts by the share of its codes. 16 of each.
void weighRow(std::span<const CrownLevel> levels, const float* inLeaf, const float* bare,
              const HorizonCode* horizons, float* evergreen, float* seasonal);

/// Steps taken by crowns from each cell of a tile's blocks, in fractions of a step, so that sums are the same
/// in whatever order they are made. For one thread.
class CrownSums {
public:
    static constexpr double fractions = 4096;
    struct Steps {
        std::uint64_t evergreen = 0, seasonal = 0;
    };
    void begin(std::size_t blocks) { steps_.assign(blocks * ReceiverBlocks::cells, {}); }
    [[nodiscard]] bool begun() const { return !steps_.empty(); }
    void end() { steps_.clear(); }
    void add(std::size_t block, std::size_t cell, float evergreen, float seasonal) {
        Steps& steps = steps_[block * ReceiverBlocks::cells + cell];
        steps.evergreen += std::uint64_t(double(evergreen) * fractions + 0.5);
        steps.seasonal += std::uint64_t(double(seasonal) * fractions + 0.5);
    }
    [[nodiscard]] std::span<const Steps> steps() const { return steps_; }

private:
    std::vector<Steps> steps_;  // row by row in each block
};

/// The crowns and suns of a period.
class CrownSweep {
public:
    /// At most so many levels a bin.
    static constexpr std::size_t maxLevels = 24;
    /// `scene` and `binned` are of the same steps; `datumM`: local z from which heights count.
    CrownSweep(const CrownScene& scene, const BinnedSun& binned, const Grid& grid, double datumM);

    [[nodiscard]] std::span<const Crown> crowns() const { return crowns_; }
    [[nodiscard]] std::span<const CrownLevel> levels(std::size_t bin) const { return levels_[bin]; }
    [[nodiscard]] glm::dvec2 away(std::size_t bin) const { return away_[bin]; }
    [[nodiscard]] const Grid& grid() const { return grid_; }
    [[nodiscard]] double datumM() const { return datumM_; }
    [[nodiscard]] double widestM() const { return widestM_; }    ///< the largest radius
    [[nodiscard]] double highestM() const { return highestM_; }  ///< the highest top above the datum
    /// The crown's quadric, but for where it stands before a row.
    [[nodiscard]] const CrownOnRow& shape(std::size_t crown) const { return shapes_[crown]; }

private:
    std::vector<Crown> crowns_;
    std::vector<CrownOnRow> shapes_;
    std::vector<std::vector<CrownLevel>> levels_;  // one list a bin, from the lowest sun up
    std::vector<glm::dvec2> away_;
    Grid grid_;
    double datumM_;
    double widestM_ = 0, highestM_ = 0;
};

/// The crowns at one bin after the other. Reuses its memory; one per thread.
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
    /// null: all level.
    void add(std::size_t bin, std::size_t blockIndex, const ReceiverBlocks& blocks, const HorizonCode* codes,
             bool swapped, const BlockGround& ground, CrownSums& sums);

private:
    static constexpr std::size_t rowCells = ReceiverBlocks::side;
    /// A crown in the axes of one azimuth, metres.
    struct PlacedCrown {
        float aside, ahead;  ///< across the azimuth, and along it towards the sun, from the grid's corner
        std::uint32_t crown;
    };
    /// Those of one bin, by bands across the azimuth, in each from the farthest from the sun on.
    struct Bands {
        float lowest = 0;
        std::vector<std::uint32_t> first;  // of each band, and the end
        std::vector<PlacedCrown> crowns;
    };
    struct HiddenGap {
        std::size_t cell;
        HorizonCode low, high;
    };
    struct BlockView;

    static void place(const CrownSweep& sweep, std::size_t bin, Bands& bands);
    [[nodiscard]] BlockView viewOf(std::size_t bin, const ReceiverBlocks::Block& block, bool swapped) const;
    static void setGround(BlockView& view, const BlockGround& ground);
    bool findVisible(BlockView& view);
    void addCrowns(const Bands& bands, const BlockView& view);
    void addCrown(const PlacedCrown& placed, const BlockView& view);
    void addToRow(std::size_t crown, const BlockView& view, int row, float distance, float aside);
    void touch(int row, std::size_t first, std::size_t end);
    void countRow(std::size_t row, std::size_t blockIndex, const BlockView& view, CrownSums& sums);
    void takeGap(const HiddenGap& gap, std::size_t row, std::size_t cell, const BlockView& view,
                 float& evergreen, float& seasonal) const;

    const CrownSweep* sweep_ = nullptr;
    std::size_t firstBin_ = 0;
    std::vector<Bands> bands_;
    std::vector<HiddenGap> gaps_;
    std::size_t touchedFrom_[rowCells], touchedTo_[rowCells];  // levels of each row
    alignas(64) float inLeaf_[rowCells][CrownSweep::maxLevels][rowCells];
    alignas(64) float bare_[rowCells][CrownSweep::maxLevels][rowCells];
};

}  // namespace noonmark
