#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/filling/step_filler.h"
#include "core/engines/projected/masks/caster_reach.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

// Step masks by projected shadows. This file divides receivers that lie scattered over a city into dense
// windows, and BlockFiller fills one window at eight steps. caster_reach.h groups casters by neighbourhood
// and tells which of them reach a rectangle at some steps. This file runs a period.

/// Neighbouring receivers in a row of the grid.
struct ReceiverRun {
    int column = 0, row = 0;  ///< of the first one, in the grid
    int count = 0;
    std::uint32_t first = 0;  ///< its index in Receivers::cells; those of the others follow
};

/// A rectangle of the receivers' grid, densely filled with receivers.
struct ReceiverBlock {
    int west = 0, east = 0;  ///< columns [west, east) of the grid
    RowBand band;            ///< rows of the grid
    std::vector<ReceiverRun> runs;

    /// The layout of its rasters: from the last multiple of 64 columns before its west.
    [[nodiscard]] BitLayout layout() const { return {east, band.rows(), west / 64}; }
};

/// Divides receivers into windows that do not overlap and of which about a third or more are receivers, or
/// that are small. Parks all over a city so cost little more than their own area. O(receivers log receivers).
std::vector<ReceiverBlock> divideIntoBlocks(const Receivers& receivers);

/// The raster in which every cell of the window's layout but its receivers is set.
std::vector<std::uint64_t> rasterWithoutReceivers(const ReceiverBlock& window);

/// The casters of several cities.
struct CityCasters {
    CasterGroups common;            ///< of buildings that all cities share
    std::vector<CasterGroups> own;  ///< of the others, one entry a city
};

/// A window and the groups of casters whose shadow can reach it in a period, the nearest first.
struct BlockPlan {
    using Groups = std::vector<std::uint32_t>;

    BlockPlan(ReceiverBlock window, const CityCasters& casters, const CasterReach& period);

    ReceiverBlock window;
    std::vector<std::uint64_t> empty;  ///< raster: all but the receivers set
    Groups common;
    std::vector<Groups> own;  ///< one entry a city
};

/// Fills windows' shadows in several cities, eight steps at a time. Casters that the cities share are filled
/// once. Casters are taken from near to far, and filling ends as soon as all receivers are in shadow at all
/// eight steps, as most are while the sun is low and most casters reach. One per thread.
class BlockFiller {
public:
    /// `casters` must outlive the filler.
    explicit BlockFiller(const CityCasters& casters);

    /// Sets the window of the following calls of fill(), and finds the casters that matter to it: those
    /// whose shadow can touch it at the steps of `reach`. `plan` must outlive those calls.
    void aimAt(const BlockPlan& plan, const CasterReach& reach);

    /// Sets the bits of the window's receivers in shadow at steps [first, first + 8) of a day; one entry of
    /// `masks` a city. `reach`: of these steps, which are among those of aimAt().
    void fill(const CasterReach& reach, std::size_t first, std::span<StepMasks> masks);

private:
    using Rasters = std::vector<StepWords>;
    /// Casters of CasterGroups::indices() from `first` on, those whose bits are set.
    struct CasterBlock {
        std::size_t first = 0, count = 0;
        std::uint64_t casters = 0;
    };
    /// Casters, and what is remembered about them from call to call.
    struct Layer {
        explicit Layer(const CasterGroups& all) : groups(&all), fill(all.casters()) {}
        void choose(const BlockPlan& plan, const BlockPlan::Groups& among, const CasterReach& reach);

        const CasterGroups* groups;
        CasterFill fill;
        std::vector<CasterBlock> near;  ///< casters that matter, the nearest first
    };
    /// Returns whether anything may have been set.
    bool fillLayer(Layer& layer, const CasterReach& steps, Rasters& rasters);

    const BlockPlan* plan_ = nullptr;
    Layer common_;
    std::vector<Layer> own_;
    Rasters shared_, rasters_;
    std::vector<std::uint32_t> chosen_;
};

/// Engine::shadeSteps() with projected shadows: level ground only. The bits are those of the day's rasters
/// (computeShadowRasters()), exactly. Only casters whose shadow can reach a receiver are taken, those that
/// all cities share are filled once, and filling a place ends when it lies in shadow as a whole. Uses all
/// cores; holds the masks of a few days at a time.
Result<void> computeProjectedMasks(std::span<const City* const> cities, const Receivers& receivers,
                                   const SunSteps& sun, const TakeDay& take, Progress& progress,
                                   const std::stop_token& stop);

}  // namespace noonmark
