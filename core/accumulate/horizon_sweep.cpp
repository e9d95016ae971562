#include "core/accumulate/horizon_sweep.h"

#include <fmt/format.h>
#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <new>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/horizon_case.h"
#include "core/accumulate/horizon/period_count.h"
#include "core/accumulate/horizon/tile_horizons.h"
#include "core/accumulate/partial_field.h"
#include "core/accumulate/reach.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

// For the ranks of one tile, were all its cells receivers.
constexpr std::size_t tileBytes = std::size_t{448} << 20U;
constexpr std::size_t mostOpenTriangles = 50'000;
constexpr std::size_t partsShown = 16;
constexpr int largestTile = 1024;  // cells a side: a line of horizons stays in the first-level cache

int tileSide(std::size_t bins) {
    const double cells = double(tileBytes) / (double(std::max<std::size_t>(1, bins)) * sizeof(HorizonCode));
    return std::clamp(int(std::sqrt(cells)), 64, largestTile) / ReceiverBlocks::side * ReceiverBlocks::side;
}

/// Sweeps and counts, tile after tile.
class Sweep {
public:
    Sweep(const WallList& walls, std::span<const OpenTriangle> open, const Receivers& receivers,
          const SunSteps& sun, const BinnedSun& binned, Progress& progress, std::stop_token stop)
        : walls_(walls),
          open_(open),
          receivers_(receivers),
          binned_(binned),
          count_(sun, binned),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<void> run(ShadowField& field) {
        const std::vector<TileBox> tiles = tilesOf(receivers_.grid, tileSide(binned_.bins.size()));
        oneTile_ = tiles.size() == 1;
        for (const TileBox& box : tiles) {
            const ReceiverBlocks blocks(receivers_, box);
            if (blocks.receivers() == 0) continue;
            TileHorizons horizons(binned_.bins.size(), blocks.numbers());
            Sums hidden;
            timed(field, "sweep", [&] { hidden = sweep(blocks, horizons, field); });
            if (stop_.stop_requested()) return cancelled();
            timed(field, "count", [&] { count(blocks, horizons, hidden, field); });
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

    /// What the threads share while a tile is swept.
    struct TileWork {
        const ReceiverBlocks& blocks;
        TileHorizons& horizons;
        std::vector<std::int32_t> numbers;  // of cells, where there are open parts
        tbb::enumerable_thread_specific<Sums> sums{[this] { return Sums(blocks.numbers()); }};
        std::atomic<std::size_t> done{0};

        // Whole numbers of steps: their sum is the same in any order.
        Sums hidden() {
            Sums all(blocks.numbers());
            for (const Sums& some : sums) std::ranges::transform(all, some, all.begin(), std::plus<>());
            return all;
        }
    };

    // Where somebody looks, bins from all over the sky in turn, and in between what they come to.
    Sums sweep(const ReceiverBlocks& blocks, TileHorizons& horizons, const ShadowField& field) {
        TileWork work{blocks, horizons, {}};
        if (!open_.empty()) work.numbers = numbersOf(blocks, receivers_.grid);
        gaps_.assign(binned_.bins.size(), {});
        PartialSink* sink = oneTile_ ? progress_.partials() : nullptr;
        const std::size_t turns = sink == nullptr ? 1 : std::min(partsShown, binned_.bins.size());
        for (std::size_t turn = 0; turn < turns; ++turn) {
            const std::size_t some = (binned_.bins.size() - turn + turns - 1) / turns;
            tbb::parallel_for(std::size_t{0}, some, [&](std::size_t i) { sweep(turn + i * turns, work); });
            if (sink != nullptr && turn + 1 < turns && !stop_.stop_requested() && sink->wants())
                sink->take(partialOf(blocks, work.hidden(), turn, turns, field));
        }
        return work.hidden();
    }

    void sweep(std::size_t bin, TileWork& work) {
        if (stop_.stop_requested()) return;
        const AzimuthBin& of = binned_.bins[bin];
        const double cellM = receivers_.grid.cellM;
        const std::span<HorizonCode> codes = work.horizons.of(bin);
        outOfReach_.local() +=
            sweepBin(sweeps_.local(), walls_, work.blocks, of.away, of.lowest(), cellM, codes, stop_);
        if (!open_.empty())
            gaps_[bin] = OpenSweep(open_, work.blocks.box(), work.numbers)
                             .sweep(of.away, of.lowest(), cellM, codes, stop_);
        if (stop_.stop_requested()) return;
        count_.addHidden(bin, codes, work.sums.local());
        count_.addHidden(bin, gaps_[bin], work.sums.local());
        report(work.blocks, 0.8 * double(++work.done) / double(binned_.bins.size()));
    }

    // Of the first bins of every `turns`, up to `turn`.
    [[nodiscard]] PartialField partialOf(const ReceiverBlocks& blocks, const Sums& hidden, std::size_t turn,
                                         std::size_t turns, const ShadowField& blank) const {
        PartialField partial{.field = blank};
        std::size_t steps = 0, bins = 0;
        for (std::size_t bin = 0; bin < binned_.bins.size(); ++bin)
            if (bin % turns <= turn) steps += binned_.bins[bin].suns.size(), ++bins;
        const double minutes = blank.stepMinutes / blank.days;
        partial.field.sunlitMinutesPerDay = double(steps) * minutes;
        std::ranges::fill(partial.field.continuousMin, std::numeric_limits<float>::quiet_NaN());
        for (std::size_t i = 0; i < hidden.size(); ++i)
            if (blocks.cell(i) != ReceiverBlocks::padding)
                partial.field.grossMin[blocks.cell(i)] = float(double(hidden[i]) * minutes);
        partial.share = double(steps) / double(std::max<std::size_t>(1, count_.steps()));
        partial.part = fmt::format("{} of {} azimuth bins", bins, binned_.bins.size());
        return partial;
    }

    void count(const ReceiverBlocks& blocks, const TileHorizons& horizons, const Sums& hidden,
               ShadowField& field) {
        BinCodes codes;
        for (std::size_t bin = 0; bin < binned_.bins.size(); ++bin) codes.push_back(horizons.of(bin));
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, partsOf(blocks), [&](std::size_t part) {
            if (stop_.stop_requested()) return;
            writeMinutes(blocks, part, hidden, count_.longestRuns(codes, part, lanes_.local()), field);
            report(blocks, 0.8 + 0.2 * double(++done) / double(partsOf(blocks)));
        });
        if (!open_.empty()) count_.writeOpenRuns(blocks, codes, gaps_, field, stop_);
    }

    void report(const ReceiverBlocks& blocks, double fraction) {
        progress_.report((double(receiversDone_) + fraction * double(blocks.receivers())) /
                             double(receivers_.cells.size()),
                         "sweeping horizons");
    }

    const WallList& walls_;
    std::span<const OpenTriangle> open_;
    std::vector<std::vector<Gap>> gaps_;  // of each bin of the tile at hand
    const Receivers& receivers_;
    const BinnedSun& binned_;
    PeriodCount count_;
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    bool oneTile_ = true;
    tbb::enumerable_thread_specific<SquareSweep> sweeps_;
    tbb::enumerable_thread_specific<std::vector<RunLanes>> lanes_;
    tbb::combinable<std::uint64_t> outOfReach_{[] { return std::uint64_t{0}; }};
};

// Open parts cost much more than walls: for each triangle every cell that it may shade is looked at.
Result<std::vector<OpenTriangle>> trianglesOf(const OpenParts& open, const Grid& grid) {
    std::vector<OpenTriangle> triangles;
    for (const Part* part : open) addTriangles(*part, grid, triangles);
    if (triangles.size() <= mostOpenTriangles) return triangles;
    return failure(
        fmt::format("The horizon sweep takes prisms that stand on the ground and up to {} triangles "
                    "of other parts, and in reach there are {}",
                    mostOpenTriangles, triangles.size()),
        "engine", "Choose projected shadows or the ray reference");
}

Result<ShadowField> accumulated(const City& city, const Receivers& receivers, const SunSteps& sun,
                                double binDeg, Progress& progress, const std::stop_token& stop) {
    ShadowField field = blankField(receivers, sun);
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, sun);
    OpenParts open;
    const auto walls = standingWalls(city, used, receivers.grid, &open);
    if (!walls) return tl::make_unexpected(walls.error());
    const auto triangles = trianglesOf(open, receivers.grid);
    if (!triangles) return tl::make_unexpected(triangles.error());
    const BinnedSun binned = binnedSun(sun, binDeg);
    field.engine = fmt::format(
        "Horizon sweep: the slope of each receiver's horizon in {} azimuth bins of {} deg, every step of "
        "every day "
        "counted",
        binned.bins.size(), binDeg);
    field.cost.buildingsUsed = std::uint32_t(used.size());
    field.cost.skipped["buildings whose shadow cannot reach a receiver"] =
        city.buildings.size() - used.size();
    Sweep sweep(*walls, *triangles, receivers, sun, binned, progress, stop);
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
    if (const auto able = checkHorizonCase(city, receivers, settings_.binDeg); !able)
        return tl::make_unexpected(able.error());
    if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
    try {
        return accumulated(city, receivers, sun, settings_.binDeg, progress, stop);
    } catch (const std::bad_alloc&) {
        return failure("There is not enough memory for this study", "horizon sweep",
                       "Choose a smaller region or larger cells");
    }
}

}  // namespace noonmark
