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
#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/longest_runs.h"
#include "core/accumulate/horizon/tile_horizons.h"
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

int tileSide(std::size_t bins) {
    const double cells = double(tileBytes) / (double(std::max<std::size_t>(1, bins)) * sizeof(HorizonCode));
    return std::clamp(int(std::sqrt(cells)), 64, largestTile) / ReceiverBlocks::side * ReceiverBlocks::side;
}

/// Sweeps and counts, tile after tile.
class Sweep {
public:
    Sweep(const WallList& walls, const Receivers& receivers, const SunSteps& sun, const BinnedSun& binned,
          Progress& progress, std::stop_token stop)
        : walls_(walls),
          receivers_(receivers),
          binned_(binned),
          runs_(timedSteps(sun, binned)),
          progress_(progress),
          stop_(std::move(stop)) {
        for (const AzimuthBin& bin : binned.bins) hidden_.emplace_back(bin.suns);
    }

    Result<void> run(ShadowField& field) {
        for (const TileBox& box : tilesOf(receivers_.grid, tileSide(binned_.bins.size()))) {
            const ReceiverBlocks blocks(receivers_, box);
            if (blocks.receivers() == 0) continue;
            TileHorizons horizons(binned_.bins.size(), blocks.numbers());
            timed(field, "sweep", [&] { sweep(blocks, horizons, field); });
            if (stop_.stop_requested()) return cancelled();
            timed(field, "count", [&] { countRuns(blocks, horizons, field); });
            if (stop_.stop_requested()) return cancelled();
            receiversDone_ += blocks.receivers();
        }
        return {};
    }

    std::uint64_t outOfReach() { return outOfReach_.combine(std::plus<>()); }

private:
    using Sums = std::vector<std::uint32_t>;

    template <class Work>
    void timed(ShadowField& field, const char* stage, Work&& work) {
        const Stopwatch watch;
        work();
        field.cost.seconds[stage] += watch.seconds();
    }

    void sweep(const ReceiverBlocks& blocks, TileHorizons& horizons, ShadowField& field) {
        tbb::enumerable_thread_specific<Sums> sums{[&] { return Sums(blocks.numbers()); }};
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, binned_.bins.size(), [&](std::size_t bin) {
            if (stop_.stop_requested()) return;
            const AzimuthBin& of = binned_.bins[bin];
            const std::span<HorizonCode> codes = horizons.of(bin);
            outOfReach_.local() += sweeps_.local().sweep(walls_, blocks, of.away, of.lowest(),
                                                         receivers_.grid.cellM, codes.data(), stop_);
            if (stop_.stop_requested()) return;
            Sums& hidden = sums.local();
            for (std::size_t i = 0; i < codes.size(); ++i) hidden[i] += hidden_[bin](codes[i]);
            report(blocks, 0.8 * double(++done) / double(binned_.bins.size()));
        });
        for (const Sums& hidden : sums) addGross(blocks, hidden, field);
    }

    // Whole numbers of steps first: their sum is the same in any order.
    static void addGross(const ReceiverBlocks& blocks, const Sums& hidden, ShadowField& field) {
        for (std::size_t i = 0; i < hidden.size(); ++i)
            if (blocks.cell(i) != ReceiverBlocks::padding) field.grossMin[blocks.cell(i)] += float(hidden[i]);
    }

    void countRuns(const ReceiverBlocks& blocks, const TileHorizons& horizons, ShadowField& field) {
        std::vector<std::span<const HorizonCode>> bins;
        for (std::size_t bin = 0; bin < binned_.bins.size(); ++bin) bins.push_back(horizons.of(bin));
        const std::size_t parts = (blocks.numbers() + lanesARun - 1) / lanesARun;
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
            if (stop_.stop_requested()) return;
            std::vector<RunLanes>& lanes = lanes_.local();
            copyLanes(bins, part * lanesARun, lanes);
            write(blocks, part * lanesARun, runs_.of(lanes), field);
            report(blocks, 0.8 + 0.2 * double(++done) / double(parts));
        });
    }

    static void write(const ReceiverBlocks& blocks, std::size_t first, const RunLanes& longest,
                      ShadowField& field) {
        for (std::size_t i = 0; i < lanesARun && first + i < blocks.numbers(); ++i)
            if (const std::uint32_t cell = blocks.cell(first + i); cell != ReceiverBlocks::padding) {
                field.continuousMin[cell] = float(longest.values[i] * field.stepMinutes);
                field.grossMin[cell] = float(double(field.grossMin[cell]) * field.stepMinutes / field.days);
            }
    }

    void report(const ReceiverBlocks& blocks, double fraction) {
        progress_.report((double(receiversDone_) + fraction * double(blocks.receivers())) /
                             double(receivers_.cells.size()),
                         "sweeping horizons");
    }

    const WallList& walls_;
    const Receivers& receivers_;
    const BinnedSun& binned_;
    LongestRuns runs_;
    std::vector<HiddenSuns> hidden_;
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    tbb::enumerable_thread_specific<BinSweep> sweeps_;
    tbb::enumerable_thread_specific<std::vector<RunLanes>> lanes_;
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
