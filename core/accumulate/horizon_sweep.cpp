#include "core/accumulate/horizon_sweep.h"

#include <fmt/format.h>
#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/longest_runs.h"
#include "core/accumulate/horizon/tile_ranks.h"
#include "core/accumulate/reach.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

// For the ranks of one tile, were all its cells receivers.
constexpr std::size_t tileBytes = std::size_t{448} << 20U;
constexpr int largestTile = 1024;  // cells a side: a line of horizons stays in the first-level cache
constexpr std::uint32_t mostStepsADay = 32'767;

Result<void> checkCase(const City& city, const Receivers& receivers, const SunSteps& sun, double binDeg) {
    if (!(binDeg >= HorizonSweepSettings::minBinDeg && binDeg <= HorizonSweepSettings::maxBinDeg))
        return failure(fmt::format("An azimuth bin of {} deg is out of range", binDeg), "bin width",
                       "Choose 0.1 to 2 deg");
    if (city.terrain || !receivers.flat())
        return failure("The horizon sweep works on flat ground only, and this city has terrain", "engine",
                       "Choose the ray reference");
    for (const SunDay& day : sun.days)
        if (day.count > mostStepsADay)
            return failure(fmt::format("A day of {} steps is more than the horizon sweep counts", day.count),
                           "step", "Choose a step of 3 seconds or more");
    return {};
}

std::vector<TimedStep> timedSteps(const SunSteps& sun, const BinnedSun& binned) {
    std::vector<TimedStep> steps(sun.steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = {binned.places[i], i == 0 || sun.steps[i].slot != sun.steps[i - 1].slot + 1};
    for (const SunDay& day : sun.days)
        if (day.count > 0) steps[day.first].startsRun = true;
    return steps;
}

int tileSide(std::size_t bins) {
    const double cells = double(tileBytes) / (double(std::max<std::size_t>(1, bins)) * sizeof(std::int16_t));
    return std::clamp(int(std::sqrt(cells)), 64, largestTile);
}

std::vector<TileBox> tilesOf(const Grid& grid, int side) {
    std::vector<TileBox> tiles;
    for (int row = 0; row < grid.rows; row += side)
        for (int column = 0; column < grid.columns; column += side)
            tiles.push_back(
                {column, row, std::min(side, grid.columns - column), std::min(side, grid.rows - row)});
    return tiles;
}

/// Sweeps and counts, tile after tile.
class Sweep {
public:
    Sweep(const WallList& walls, const Receivers& receivers, const SunSteps& sun, const BinnedSun& binned,
          Progress& progress, std::stop_token stop)
        : walls_(walls),
          receivers_(receivers),
          binned_(binned),
          steps_(timedSteps(sun, binned)),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<void> run(ShadowField& field) {
        for (const TileBox& box : tilesOf(receivers_.grid, tileSide(binned_.bins.size()))) {
            const TileReceivers tile(receivers_, box);
            if (tile.count() == 0) continue;
            TileRanks ranks(binned_.bins.size(), tile.count());
            timed(field, "sweep", [&] { sweep(tile, ranks); });
            if (stop_.stop_requested()) return cancelled();
            timed(field, "count", [&] { count(tile, ranks, field); });
            if (stop_.stop_requested()) return cancelled();
            receiversDone_ += tile.count();
        }
        return {};
    }

    std::uint64_t outOfReach() { return outOfReach_.combine(std::plus<>()); }

private:
    template <class Work>
    void timed(ShadowField& field, const char* stage, Work&& work) {
        const Stopwatch watch;
        work();
        field.cost.seconds[stage] += watch.seconds();
    }

    void sweep(const TileReceivers& tile, TileRanks& ranks) {
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, binned_.bins.size(), [&](std::size_t bin) {
            if (stop_.stop_requested()) return;
            outOfReach_.local() += sweeps_.local().sweep(walls_, tile, binned_.bins[bin],
                                                         receivers_.grid.cellM, ranks.of(bin), stop_);
            report(tile, 0.5 * double(++done) / double(binned_.bins.size()));
        });
    }

    void count(const TileReceivers& tile, const TileRanks& ranks, ShadowField& field) {
        const std::size_t blocks = (tile.count() + receiversABlock - 1) / receiversABlock;
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
            if (stop_.stop_requested()) return;
            std::vector<BlockRanks>& ofBlock = blocks_.local();
            ranks.copyBlock(block, ofBlock);
            const BlockRanks longest = longestRuns(ofBlock, steps_);
            const BlockSums hidden = sumsOf(ofBlock);
            for (std::size_t i = 0, number = block * receiversABlock;
                 i < receiversABlock && number < tile.count(); ++i, ++number) {
                field.grossMin[tile.cell(number)] = float(hidden.values[i] * field.stepMinutes / field.days);
                field.continuousMin[tile.cell(number)] = float(longest.values[i] * field.stepMinutes);
            }
            report(tile, 0.5 + 0.5 * double(++done) / double(blocks));
        });
    }

    void report(const TileReceivers& tile, double fraction) {
        progress_.report(
            (double(receiversDone_) + fraction * double(tile.count())) / double(receivers_.cells.size()),
            "sweeping horizons");
    }

    const WallList& walls_;
    const Receivers& receivers_;
    const BinnedSun& binned_;
    std::vector<TimedStep> steps_;
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    tbb::enumerable_thread_specific<BinSweep> sweeps_;
    tbb::enumerable_thread_specific<std::vector<BlockRanks>> blocks_;
    tbb::combinable<std::uint64_t> outOfReach_{[] { return std::uint64_t{0}; }};
};

Result<ShadowField> accumulated(const City& city, const Receivers& receivers, const SunSteps& sun,
                                double binDeg, Progress& progress, const std::stop_token& stop) {
    ShadowField field = blankField(receivers, sun);
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, sun);
    const auto walls = standingWalls(city, used, receivers.grid);
    if (!walls) return tl::make_unexpected(walls.error());
    const BinnedSun binned = binnedSun(sun, binDeg);
    field.engine = fmt::format(
        "Horizon sweep: the slope of each receiver's horizon in {} azimuth bins of {} deg, every step of "
        "every day "
        "counted",
        binned.bins.size(), binDeg);
    field.cost.buildingsUsed = std::uint32_t(used.size());
    field.cost.skipped["buildings whose shadow cannot reach a receiver"] =
        city.buildings.size() - used.size();
    Sweep sweep(*walls, receivers, sun, binned, progress, stop);
    field.cost.seconds["build"] = watch.seconds();
    if (const auto done = sweep.run(field); !done) return tl::make_unexpected(done.error());
    field.cost.skipped["prisms whose shadow cannot reach a tile (prisms x azimuth bins)"] =
        sweep.outOfReach();
    progress.report(1, "sweeping horizons");
    return field;
}

}  // namespace

HorizonSweep::HorizonSweep(HorizonSweepSettings settings) : settings_(settings) {}

Result<ShadowField> HorizonSweep::accumulate(const City& city, const Receivers& receivers,
                                             const SunSteps& sun, Progress& progress,
                                             std::stop_token stop) const {
    if (const auto able = checkCase(city, receivers, sun, settings_.binDeg); !able)
        return tl::make_unexpected(able.error());
    try {
        return accumulated(city, receivers, sun, settings_.binDeg, progress, stop);
    } catch (const std::bad_alloc&) {
        return failure("There is not enough memory for this study", "horizon sweep",
                       "Choose a smaller region or larger cells");
    }
}

}  // namespace noonmark
