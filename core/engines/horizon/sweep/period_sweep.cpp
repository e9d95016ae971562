#include "core/engines/horizon/sweep/period_sweep.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/counting/short_sums.h"

namespace noonmark {

namespace {

// Memory for the horizons of one tile, and the marks of crowns, if all its cells are receivers.
constexpr std::size_t tileBytes = std::size_t{448} << 20U;
constexpr std::size_t partsShown = 16, batchesPerPart = 4;
constexpr std::size_t tasks = 64;  // minimum number of tasks, so that all cores have work until the end
constexpr int largestTile = 1024;  // cells per side: a row of horizons stays in the first-level cache

// `cellBytes`: of a cell in a bin.
int tileSide(std::size_t bins, std::size_t cellBytes) {
    const double cells = double(tileBytes) / double(std::max<std::size_t>(1, bins) * cellBytes);
    return std::clamp(int(std::sqrt(cells)), 64, largestTile) / ReceiverBlocks::side * ReceiverBlocks::side;
}

// So that the sums of crowns fit, if all cells are receivers.
int crownTileSide(std::size_t sets) {
    constexpr std::size_t bytes = std::size_t{64} << 20U;  // in each thread
    const double blocks = double(bytes) / double(std::max<std::size_t>(1, sets) * CrownSums::bytesPerBlock);
    return std::max(1, int(std::sqrt(blocks))) * ReceiverBlocks::side;
}

// Divides into tiles of nearly equal size, because each examines all walls in reach.
int evenSide(int cells, int maximum) {
    const int tiles = (cells + maximum - 1) / maximum, side = (cells + tiles - 1) / tiles;
    return (side + ReceiverBlocks::side - 1) / ReceiverBlocks::side * ReceiverBlocks::side;
}

// For a single tile with these receivers.
bool horizonsFit(const Receivers& receivers, std::size_t bins, std::size_t cellBytes) {
    constexpr std::size_t paddingABlock = 32, cellsABlock = ReceiverBlocks::cells;
    const std::size_t numbers = receivers.cells.size() + receivers.grid.size() / cellsABlock * paddingABlock;
    return numbers * bins * cellBytes <= tileBytes;
}

// With many overhangs each bin becomes a batch of its own, because every azimuth of a batch stores which
// overhangs may be seen from which block.
std::vector<BatchRange> batchesAmong(std::span<const OverhangShapes> overhangs,
                                     std::span<const SweptBin> bins) {
    constexpr std::size_t maxInBatches = 4096;
    std::size_t shapes = 0;
    for (const OverhangShapes& some : overhangs) shapes += some.size();
    if (shapes <= maxInBatches) return groupIntoBatches(bins);
    std::vector<BatchRange> ones;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) ones.push_back({bin, bin + 1});
    return ones;
}

}  // namespace

/// Data shared by the threads while a tile is swept and counted.
struct PeriodSweep::Tile {
    Tile(const Receivers& receivers, const TileBox& box, double datumM, std::size_t bins)
        : blocks(receivers, box), grounds(receivers, blocks, datumM), horizons(bins, blocks.numbers()) {}
    ReceiverBlocks blocks;
    BlockGrounds grounds;
    TileHorizons horizons;  ///< no bins if horizons are not stored
    OverhangTile overhangs;
    CrownMarks crownMarks;               ///< if the longest runs of crowns are counted
    std::vector<std::vector<Gap>> gaps;  ///< one list per bin
    std::atomic<std::size_t> done{0};    ///< finished bins
};

PeriodSweep::PeriodSweep(const WallList& walls, std::span<const OverhangShapes> overhangs,
                         const Receivers& receivers, const SunSteps& sun, const BinnedSun& binned,
                         ShadowCounts counts, RunRays* rays, Progress& progress, std::stop_token stop)
    : walls_(walls),
      overhangs_(listOf(overhangs)),
      receivers_(receivers),
      binned_(binned),
      bins_(makeSweptBins(binned.bins)),
      batches_(batchesAmong(overhangs, bins_)),
      count_(sun, binned, counts),
      doubts_(binned, sun.stepMinutes),
      rays_(rays),
      keeps_(counts == ShadowCounts::grossAndRuns),
      progress_(progress),
      stop_(std::move(stop)) {}

std::uint64_t PeriodSweep::outOfReach() { return outOfReach_.combine(std::plus<>()); }

// A single tile if the receivers' horizons fit. Sums of crowns by month take more memory, in each thread.
std::vector<TileBox> PeriodSweep::tiles() const {
    const Grid& grid = receivers_.grid;
    const int size = std::max({1, grid.columns, grid.rows});
    // Of crowns in leaf and bare, where all cells are near trees.
    const std::size_t cellBytes = sizeof(HorizonCode) + (crownRuns_ ? 2 * sizeof(DarkLevels) : 0);
    const bool whole = !keeps_ || (size <= largestTile && horizonsFit(receivers_, bins_.size(), cellBytes));
    int maximum = whole ? largestTile : tileSide(bins_.size(), cellBytes);
    if (crowns_ != nullptr) maximum = std::min(maximum, crownTileSide(crowns_->sets()));
    return splitIntoTiles(grid, evenSide(size, maximum));
}

Result<void> PeriodSweep::run(ShadowField& field) {
    const std::vector<TileBox> tiles = this->tiles();
    oneTile_ = tiles.size() == 1;
    for (const TileBox& box : tiles) {
        Tile tile(receivers_, box, walls_.datumM, keeps_ ? bins_.size() : 0);
        if (tile.blocks.receivers() == 0) continue;
        timed(field, "sweep", [&] { sweep(tile, field); });
        if (stop_.stop_requested()) return cancelled();
        timed(field, "count", [&] { count(tile, field); });
        if (crowns_ != nullptr) countCrowns(tile);
        if (stop_.stop_requested()) return cancelled();
        if (count_.runs() != nullptr) timed(field, "runs", [&] { countRuns(tile, field); });
        if (stop_.stop_requested()) return cancelled();
        receiversDone_ += tile.blocks.receivers();
    }
    return {};
}

template <class Work>
void PeriodSweep::timed(ShadowField& field, const char* stage, Work&& work) {
    const Stopwatch watch;
    work();
    field.cost.seconds[stage] += watch.seconds();
}

// With a sink, batches are processed in turns that are spread over all azimuths, with a running result after
// each turn.
void PeriodSweep::sweep(Tile& tile, const ShadowField& field) {
    if (!overhangs_.empty()) tile.overhangs = OverhangTile(receivers_, tile.blocks, walls_.datumM);
    if (crownRuns_) tile.crownMarks.begin(bins_.size(), tile.blocks);
    tile.gaps.assign(bins_.size(), {});
    for (Workspace& workspace : workspaces_) {
        workspace.sums.begin(tile.blocks.blocks().size());
        workspace.crownSums.end();
    }
    PartialSink* sink = oneTile_ ? findPartialSink(progress_) : nullptr;
    const std::size_t turns =
        sink == nullptr ? 1 : std::clamp(batches_.size() / batchesPerPart, std::size_t{1}, partsShown);
    for (std::size_t turn = 0; turn < turns; ++turn) {
        const std::size_t some = (batches_.size() - turn + turns - 1) / turns;
        tbb::parallel_for(std::size_t{0}, some,
                          [&](std::size_t i) { sweep(batches_[turn + i * turns], tile); });
        if (sink != nullptr && turn + 1 < turns && !stop_.stop_requested() && sink->wants())
            sink->take(partialOf(tile, {turn, turns}, field));
    }
}

void PeriodSweep::sweep(const BatchRange& batch, Tile& tile) {
    if (stop_.stop_requested()) return;
    Workspace& workspace = workspaces_.local();
    if (!workspace.sums.begun()) workspace.sums.begin(tile.blocks.blocks().size());
    const TileScene scene{walls_, tile.blocks, tile.grounds, receivers_.grid.cellM};
    const std::span<const SweptBin> bins = std::span(bins_).subspan(batch.first, batch.size());
    if (!overhangs_.empty()) workspace.overhangs.begin(overhangs_, tile.overhangs, bins, scene.cellM, stop_);
    if (crowns_ != nullptr) {
        workspace.crowns.begin(*crowns_, batch.first, batch.end);
        if (!workspace.crownSums.begun())
            workspace.crownSums.begin(crowns_->sets(), tile.blocks.blocks().size(), crowns_->steps());
    }
    const auto take = [&](std::size_t i, std::size_t block, const HorizonCode* codes, bool swapped) {
        const std::size_t bin = batch.first + i;
        if (!overhangs_.empty()) codes = withOverhangs(batch, i, {block, codes, swapped}, tile, workspace);
        if (crowns_ != nullptr)
            workspace.crowns.add(bin, block, tile.blocks, codes, swapped, tile.grounds.of(block, swapped),
                                 workspace.crownSums, crownRuns_ ? &tile.crownMarks : nullptr);
        if (keeps_)
            writeBlock(codes, tile.blocks, tile.blocks.blocks()[block], swapped,
                       tile.horizons.of(bin).data());
        else
            workspace.sums.add(block, swapped, codes, count_.suns(bin));
    };
    outOfReach_.local() += workspace.sweep.run(scene, bins, take, stop_);
    if (stop_.stop_requested()) return;
    for (std::size_t bin = batch.first; bin < batch.end && keeps_; ++bin) sortByNumber(tile.gaps[bin]);
    tile.done += batch.size();
    report(tile.blocks, 0.8 * double(tile.done) / double(bins_.size()));
}

// Gaps that contain suns of the bin are stored, or counted at once.
const HorizonCode* PeriodSweep::withOverhangs(const BatchRange& batch, std::size_t i, const SweptBlock& swept,
                                              Tile& tile, Workspace& workspace) {
    const std::size_t bin = batch.first + i;
    const AzimuthBin& suns = binned_.bins[bin];
    return workspace.overhangs.raise(
        i, swept, tile.blocks, tile.grounds, [&](int cell, HorizonCode low, HorizonCode high) {
            if (crowns_ != nullptr) workspace.crowns.hide(cell, low, high);
            const std::uint32_t steps = suns.hiddenBy(high) - suns.hiddenBy(low);
            if (steps == 0) return;
            if (keeps_)
                tile.gaps[bin].push_back(
                    {tile.overhangs.numberOf(tile.blocks.blocks()[swept.block], cell), low, high});
            else
                workspace.sums.add(swept.block, std::size_t(cell), steps);
        });
}

// Steps hidden by the batches up to a turn, one per number.
PeriodSweep::Sums PeriodSweep::hidden(Tile& tile, const Turns& turns) {
    if (keeps_) return hiddenByCached(tile, turns);
    Sums sums(tile.blocks.numbers());
    for (Workspace& workspace : workspaces_) workspace.sums.addTo(tile.blocks, sums);
    return sums;
}

PeriodSweep::Sums PeriodSweep::hiddenByCached(Tile& tile, const Turns& turns) const {
    Sums sums(tile.blocks.numbers());
    const std::size_t numbers =
        std::min(maxShortNumbers,
                 (sums.size() / tasks + lanesPerPart - 1) / lanesPerPart * lanesPerPart + lanesPerPart);
    tbb::parallel_for(std::size_t{0}, (sums.size() + numbers - 1) / numbers, [&](std::size_t task) {
        const auto first = std::uint32_t(task * numbers),
                   end = std::uint32_t(std::min(sums.size(), (task + 1) * numbers));
        const NumberRange own{first, end};
        TileShortSums some(first, {&own, 1}, sums.data());
        for (std::size_t batch = 0; batch < batches_.size() && !stop_.stop_requested(); ++batch)
            for (std::size_t bin = batches_[batch].first; bin < batches_[batch].end && turns.have(batch);
                 ++bin)
                for (const CountChange& suns : count_.suns(bin)) some.add(suns, tile.horizons.of(bin).data());
        some.flush();
    });
    for (std::size_t bin = 0; bin < tile.gaps.size(); ++bin)
        for (const Gap& gap : tile.gaps[bin])
            sums[gap.number] += binned_.bins[bin].hiddenBy(gap.high) - binned_.bins[bin].hiddenBy(gap.low);
    return sums;
}

PartialField PeriodSweep::partialOf(Tile& tile, const Turns& turns, const ShadowField& blank) {
    const Sums hidden = this->hidden(tile, turns);
    PartialField partial{.field = blank};
    std::size_t steps = 0, bins = 0;
    for (std::size_t batch = 0; batch < batches_.size(); ++batch)
        for (std::size_t bin = batches_[batch].first; bin < batches_[batch].end && turns.have(batch); ++bin)
            steps += binned_.bins[bin].suns.size(), ++bins;
    const double minutes = blank.stepMinutes / blank.days;
    partial.field.sunlitMinutesPerDay = double(steps) * minutes;
    std::ranges::fill(partial.field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < hidden.size(); ++i)
        if (const std::uint32_t cell = tile.blocks.cell(i); cell != ReceiverBlocks::padding)
            partial.field.grossMin[cell] = float(double(hidden[i]) * minutes);
    partial.share = double(steps) / double(std::max<std::size_t>(1, binned_.places.size()));
    partial.part = fmt::format("{} of {} directions of the sun", bins, bins_.size());
    return partial;
}

void PeriodSweep::count(Tile& tile, ShadowField& field) {
    const Sums hidden = this->hidden(tile, {});
    for (std::size_t part = 0; part < partsOf(tile.blocks); ++part)
        writeGross(tile.blocks, part, hidden, field);
}

void PeriodSweep::weigh(const CrownSweep* crowns, std::span<const std::uint8_t> inLeaf) {
    crowns_ = crowns;
    if (crowns == nullptr) return;
    const std::vector<std::vector<double>> none(crowns->sets(), std::vector<double>(receivers_.cells.size()));
    taken_ = {none, none, {}, {}};
    if (count_.runs() == nullptr) return;
    crownRuns_.emplace(*crowns, count_.runs()->steps(), inLeaf);
    taken_.evergreenRuns.assign(receivers_.grid.size(), 0);
    taken_.seasonalRuns.assign(receivers_.grid.size(), 0);
}

// Of each number of a tile its place among all receivers; padding where it is none.
std::vector<std::uint32_t> PeriodSweep::listReceiverNumbers(const ReceiverBlocks& blocks) const {
    std::vector<std::uint32_t> receivers(blocks.numbers(), ReceiverBlocks::padding);
    for (std::uint32_t n = 0; n < blocks.numbers(); ++n)
        if (const std::uint32_t cell = blocks.cell(n); cell != ReceiverBlocks::padding)
            receivers[n] =
                std::uint32_t(std::ranges::lower_bound(receivers_.cells, cell) - receivers_.cells.begin());
    return receivers;
}

void PeriodSweep::countCrowns(const Tile& tile) {
    const std::vector<std::uint32_t> receivers = listReceiverNumbers(tile.blocks);
    tbb::parallel_for(std::size_t{0}, crowns_->sets(), [&](std::size_t set) {
        for (const Workspace& workspace : workspaces_)
            if (workspace.crownSums.begun()) addTaken(tile.blocks, workspace.crownSums, set, receivers);
    });
}

void PeriodSweep::addTaken(const ReceiverBlocks& blocks, const CrownSums& sums, std::size_t set,
                           const std::vector<std::uint32_t>& receivers) {
    for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
        const ReceiverBlocks::Block& block = blocks.blocks()[i];
        const std::uint8_t* places = blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const std::uint32_t receiver = receivers[block.first + n];
            if (receiver == ReceiverBlocks::padding) continue;
            const CrownSums::Steps taken = sums.steps(set, i, places[n]);
            taken_.evergreen[set][receiver] += taken.evergreen;
            taken_.seasonal[set][receiver] += taken.seasonal;
        }
    }
}

void PeriodSweep::countRuns(const Tile& tile, ShadowField& field) {
    BinCodes codes;
    for (std::size_t bin = 0; bin < bins_.size(); ++bin) codes.push_back(tile.horizons.of(bin));
    const BinGaps gaps(tile.gaps.begin(), tile.gaps.end());
    const RunCount& runs = *count_.runs();
    std::optional<RunDecider> decider;
    if (rays_ != nullptr) decider.emplace(doubts_, *rays_, tile.blocks);
    std::atomic<std::size_t> done{0};
    const std::size_t parts = partsOf(tile.blocks);
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        if (stop_.stop_requested()) return;
        RunMemory& memory = runMemory_.local();
        const RunLanes longest = decider ? runs.decidedRuns(codes, gaps, part, *decider,
                                                            findReceiverLanes(tile.blocks, part), memory)
                                         : runs.longestRuns(codes, gaps, part, memory);
        writeRuns(tile.blocks, part, longest, field);
        if (crownRuns_) countCrownRuns(tile, part, longest, memory);
        report(tile.blocks, 0.8 + 0.2 * double(++done) / double(parts));
    });
}

void PeriodSweep::countCrownRuns(const Tile& tile, std::size_t part, const RunLanes& decided,
                                 const RunMemory& memory) {
    const CrownRunCount::Runs runs =
        crownRuns_->of(memory, tile.crownMarks, part, decided, crownRunMemory_.local());
    const std::size_t first = part * lanesPerPart;
    for (std::size_t i = 0; i < lanesPerPart && first + i < tile.blocks.numbers(); ++i) {
        const std::uint32_t cell = tile.blocks.cell(first + i);
        if (cell == ReceiverBlocks::padding) continue;
        taken_.evergreenRuns[cell] = runs.evergreen.values[i];
        taken_.seasonalRuns[cell] = runs.seasonal.values[i];
    }
}

void PeriodSweep::report(const ReceiverBlocks& blocks, double fraction) {
    progress_.report(
        (double(receiversDone_) + fraction * double(blocks.receivers())) / double(receivers_.cells.size()),
        NM_TEXT("sweeping horizons"));
}

}  // namespace noonmark
