#include "core/accumulate/horizon/period_sweep.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "core/accumulate/horizon/short_sums.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

// For the ranks of one tile, were all its cells receivers.
constexpr std::size_t tileBytes = std::size_t{448} << 20U;
constexpr std::size_t partsShown = 16;
constexpr std::size_t tasks = 64;  // at least, so that all cores have work to the end
constexpr int largestTile = 1024;  // cells a side: a line of horizons stays in the first-level cache

int tileSide(std::size_t bins) {
    const double cells = double(tileBytes) / (double(std::max<std::size_t>(1, bins)) * sizeof(HorizonCode));
    return std::clamp(int(std::sqrt(cells)), 64, largestTile) / ReceiverBlocks::side * ReceiverBlocks::side;
}

// Of about the same size: each looks at all walls in reach.
int evenSide(int cells, int most) {
    const int tiles = (cells + most - 1) / most, side = (cells + tiles - 1) / tiles;
    return (side + ReceiverBlocks::side - 1) / ReceiverBlocks::side * ReceiverBlocks::side;
}

// One tile where the receivers' horizons fit.
std::vector<TileBox> tilesFor(const Receivers& receivers, std::size_t bins) {
    const Grid& grid = receivers.grid;
    const int size = std::max({1, grid.columns, grid.rows});
    constexpr std::size_t paddingABlock = 32, cellsABlock = ReceiverBlocks::cells;
    const std::size_t numbers = receivers.cells.size() + grid.size() / cellsABlock * paddingABlock;
    const bool fits = size <= largestTile && numbers * bins * sizeof(HorizonCode) <= tileBytes;
    return tilesOf(grid, evenSide(size, fits ? largestTile : tileSide(bins)));
}

}  // namespace

/// What the threads share while a tile is swept.
struct PeriodSweep::TileWork {
    const ReceiverBlocks& blocks;
    BlockGrounds grounds;
    TileHorizons& horizons;
    OpenTile open;
    std::atomic<std::size_t> done{0};
};

PeriodSweep::PeriodSweep(const WallList& walls, std::span<const OpenTriangle> open,
                         const Receivers& receivers, const SunSteps& sun, const BinnedSun& binned,
                         Progress& progress, std::stop_token stop)
    : walls_(walls),
      open_(open),
      receivers_(receivers),
      binned_(binned),
      count_(sun, binned, !open.empty()),
      progress_(progress),
      stop_(std::move(stop)) {}

std::uint64_t PeriodSweep::outOfReach() { return outOfReach_.combine(std::plus<>()); }

Result<void> PeriodSweep::run(ShadowField& field) {
    const std::vector<TileBox> tiles = tilesFor(receivers_, binned_.bins.size());
    oneTile_ = tiles.size() == 1;
    for (const TileBox& box : tiles) {
        const ReceiverBlocks blocks(receivers_, box);
        if (blocks.receivers() == 0) continue;
        TileHorizons horizons(binned_.bins.size(), blocks.numbers());
        timed(field, "sweep", [&] { sweep(blocks, horizons, field); });
        if (stop_.stop_requested()) return cancelled();
        timed(field, "count", [&] { count(blocks, horizons, field); });
        if (stop_.stop_requested()) return cancelled();
        receiversDone_ += blocks.receivers();
    }
    return {};
}

template <class Work>
void PeriodSweep::timed(ShadowField& field, const char* stage, Work&& work) {
    const Stopwatch watch;
    work();
    field.cost.seconds[stage] += watch.seconds();
}

// Where somebody looks, bins from all over the sky in turn, and in between what they come to.
void PeriodSweep::sweep(const ReceiverBlocks& blocks, TileHorizons& horizons, const ShadowField& field) {
    TileWork work{blocks, {receivers_, blocks, walls_.datumM}, horizons, {}};
    if (!open_.empty()) work.open = OpenTile(receivers_, blocks, walls_.datumM);
    gaps_.assign(binned_.bins.size(), {});
    PartialSink* sink = oneTile_ ? progress_.partials() : nullptr;
    const std::size_t turns = sink == nullptr ? 1 : std::min(partsShown, binned_.bins.size());
    for (std::size_t turn = 0; turn < turns; ++turn) {
        const std::size_t some = (binned_.bins.size() - turn + turns - 1) / turns;
        tbb::parallel_for(std::size_t{0}, some, [&](std::size_t i) { sweep(turn + i * turns, work); });
        if (sink != nullptr && turn + 1 < turns && !stop_.stop_requested() && sink->wants())
            sink->take(partialOf(blocks, horizons, {turn, turns}, field));
    }
}

void PeriodSweep::sweep(std::size_t bin, TileWork& work) {
    if (stop_.stop_requested()) return;
    const AzimuthBin& of = binned_.bins[bin];
    const double cellM = receivers_.grid.cellM;
    const std::span<HorizonCode> codes = work.horizons.of(bin);
    outOfReach_.local() += sweepBin(sweeps_.local(), walls_, work.blocks, work.grounds, of.away, of.lowest(),
                                    cellM, codes, stop_);
    if (!open_.empty())
        gaps_[bin] = openAbove(
            openSweeps_.local().intervals({open_, work.open, of.away, of.lowest(), cellM}, codes, stop_),
            of.lowest(), count_.hidden(bin), codes);
    if (stop_.stop_requested()) return;
    report(work.blocks, 0.8 * double(++work.done) / double(binned_.bins.size()));
}

// Steps hidden by the bins of some turns, one a number.
PeriodSweep::Sums PeriodSweep::hidden(const ReceiverBlocks& blocks, const TileHorizons& horizons,
                                      const Turns& turns) const {
    Sums sums(blocks.numbers());
    const std::size_t numbers =
        std::min(ShortSums::mostNumbers,
                 (blocks.numbers() / tasks + lanesARun - 1) / lanesARun * lanesARun + lanesARun);
    tbb::parallel_for(std::size_t{0}, (sums.size() + numbers - 1) / numbers, [&](std::size_t task) {
        const auto first = std::uint32_t(task * numbers),
                   end = std::uint32_t(std::min(sums.size(), (task + 1) * numbers));
        const Stretch own{first, end};
        ShortSums some(first, {&own, 1}, sums.data());
        for (std::size_t bin = 0; bin < binned_.bins.size() && !stop_.stop_requested(); ++bin)
            if (turns.have(bin))
                for (const SunChange& suns : count_.suns(bin)) some.add(suns, horizons.of(bin).data());
        some.flush();
    });
    for (std::size_t bin = 0; bin < gaps_.size(); ++bin)
        for (const Gap& gap : gaps_[bin])
            sums[gap.number] += count_.hidden(bin)(gap.high) - count_.hidden(bin)(gap.low);
    return sums;
}

PartialField PeriodSweep::partialOf(const ReceiverBlocks& blocks, const TileHorizons& horizons,
                                    const Turns& turns, const ShadowField& blank) const {
    const Sums hidden = this->hidden(blocks, horizons, turns);
    PartialField partial{.field = blank};
    std::size_t steps = 0, bins = 0;
    for (std::size_t bin = 0; bin < binned_.bins.size(); ++bin)
        if (turns.have(bin)) steps += binned_.bins[bin].suns.size(), ++bins;
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

void PeriodSweep::count(const ReceiverBlocks& blocks, const TileHorizons& horizons, ShadowField& field) {
    const Sums hidden = this->hidden(blocks, horizons, {});
    BinCodes codes;
    for (std::size_t bin = 0; bin < binned_.bins.size(); ++bin) codes.push_back(horizons.of(bin));
    const BinGaps gaps(gaps_.begin(), gaps_.end());
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, partsOf(blocks), [&](std::size_t part) {
        if (stop_.stop_requested()) return;
        writeMinutes(blocks, part, hidden, count_.runs().longestRuns(codes, gaps, part, runMemory_.local()),
                     field);
        report(blocks, 0.8 + 0.2 * double(++done) / double(partsOf(blocks)));
    });
}

void PeriodSweep::report(const ReceiverBlocks& blocks, double fraction) {
    progress_.report(
        (double(receiversDone_) + fraction * double(blocks.receivers())) / double(receivers_.cells.size()),
        "sweeping horizons");
}

}  // namespace noonmark
