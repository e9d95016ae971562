#include "core/engines/horizon/attribution/horizon_breakdown.h"

#include <fmt/format.h>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>

#include "core/describe/text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/horizon/attribution/step_sums.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/horizon/sweep/tile_sweep.h"

namespace noonmark {

namespace {

// The sums of a tile's receivers shall stay in the second-level cache. Each tile examines all walls in reach,
// so tiles are larger where receivers lie far apart.
int chooseTileSide(const Receivers& receivers) {
    constexpr double maximum = 65536;  // receivers of a tile
    constexpr int minimum = 512;       // cells
    const double share =
        double(receivers.cells.size()) / double(std::max<std::size_t>(1, receivers.grid.size()));
    const int largest = std::max(receivers.grid.columns, receivers.grid.rows);
    int side = minimum;
    while (side < largest && share * 4 * side * side <= maximum) side *= 2;
    return side;
}

/// The receivers of a tile, in the forms that walls and overhangs need.
struct Tile {
    Tile(const Receivers& receivers, const TileBox& box, double datumM)
        : blocks(receivers, box), grounds(receivers, blocks, datumM), overhangs(receivers, blocks, datumM) {}
    ReceiverBlocks blocks;
    BlockGrounds grounds;
    OverhangTile overhangs;
};

// Whole blocks around the receivers of a tile, in which they stay as they are: fewer walls reach it where
// places lie far apart. Empty: there are none.
TileBox cropToReceivers(const TileBox& box, const Receivers& receivers) {
    constexpr int side = ReceiverBlocks::side;
    glm::ivec2 low{box.columns, box.rows}, high{0, 0};
    for (int row = 0; row < box.rows; ++row)
        for (int column = 0; column < box.columns; ++column)
            if (isReceiver(
                    receivers.kind[receivers.grid.index(box.firstColumn + column, box.firstRow + row)])) {
                low = glm::min(low, glm::ivec2(column, row));
                high = glm::max(high, glm::ivec2(column, row) + 1);
            }
    if (high.x == 0) return {};
    low = low / side * side;
    high = glm::min((high + side - 1) / side * side, glm::ivec2(box.columns, box.rows));
    return {box.firstColumn + low.x, box.firstRow + low.y, high.x - low.x, high.y - low.y};
}

/// A receiver of a tile: its number there, and its place among all receivers.
struct NumberedReceiver {
    std::uint32_t number, receiver;
};

// Most receivers follow the one before in the row of their block.
std::vector<NumberedReceiver> listReceivers(const ReceiverBlocks& blocks, const ShadowBreakdown& breakdown) {
    std::vector<NumberedReceiver> list;
    list.reserve(blocks.receivers());
    std::uint32_t before = ReceiverBlocks::padding - 1;  // the cell of the last one
    for (std::uint32_t n = 0; n < blocks.numbers(); ++n) {
        const std::uint32_t cell = blocks.cell(n);
        if (cell == ReceiverBlocks::padding) continue;
        const bool follows = !list.empty() && cell == before + 1;
        list.push_back(
            {n, follows ? list.back().receiver + 1 : std::uint32_t(findReceiver(breakdown, cell))});
        before = cell;
    }
    return list;
}

// The whole number that stands for a share of 1: sums of whole numbers are the same in whatever order threads
// add up. The largest power of two, up to 2^32, with which all steps of all receivers do not overflow 63
// bits.
double chooseUnit(const Receivers& receivers, std::size_t steps) {
    constexpr double bits = 63, maxUnit = 32;
    const double maxShare = std::ranges::max(receivers.shares);
    const double largest = std::max(1.0, maxShare) * double(receivers.cells.size()) * double(steps);
    return std::exp2(std::clamp(std::floor(bits - std::log2(std::max(1.0, largest))), 0.0, maxUnit));
}

class Breakdown {
public:
    /// All arguments must outlive it.
    Breakdown(const WallList& walls, std::span<const OverhangShapes> overhangs, const Receivers& receivers,
              const BinnedSun& binned, const StepSets& sets, bool byBuilding, Progress& progress,
              std::stop_token stop)
        : walls_(walls),
          overhangs_(overhangs),
          overhangList_(listOf(overhangs)),
          casters_(byBuilding ? walls.terrainNumber + 1 : 0),
          receivers_(receivers),
          bins_(makeSweptBins(binned.bins)),
          batches_(groupIntoBatches(bins_)),
          tables_(setTables(binned, sets)),
          weighs_(byBuilding && !receivers.shares.empty()),
          unit_(weighs_ ? chooseUnit(receivers, sets.ofStep.size()) : 1),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<void> run(ShadowBreakdown& breakdown, double stepMinutes) {
        for (const TileBox& whole : splitIntoTiles(receivers_.grid, chooseTileSide(receivers_))) {
            const TileBox box = cropToReceivers(whole, receivers_);
            if (box.columns == 0) continue;
            const Tile tile(receivers_, box, walls_.datumM);
            const std::vector<NumberedReceiver> numbered = listReceivers(tile.blocks, breakdown);
            if (weighs_) weigh(tile, numbered);
            for (Work& work : works_) begin(work, tile, breakdown.sets.names.size());
            sweep(tile, breakdown.sets.names.size());
            if (stop_.stop_requested()) return cancelled();
            for (Work& work : works_) work.sums.flush();
            addCells(numbered, breakdown);
            receiversDone_ += tile.blocks.receivers();
        }
        tbb::parallel_for(std::size_t{0}, breakdown.minutes.size(), [&](std::size_t set) {
            for (float& minutes : breakdown.minutes[set]) minutes = float(double(minutes) * stepMinutes);
        });
        addCasters(breakdown, stepMinutes * receivers_.grid.cellAreaM2() / unit_);
        return {};
    }

private:
    /// Per-thread memory.
    struct Work {
        StepSums sums;
        TileSweep sweep;
        std::vector<std::vector<HorizonCode>> codes;  // for each bin of a batch
        OverhangSweep overhangs;
        AttributedTile ranks;
        BuildingGapFinder owned;
    };

    void weigh(const Tile& tile, const std::vector<NumberedReceiver>& numbered) {
        weights_.assign(tile.blocks.numbers(), 0);
        for (const NumberedReceiver& one : numbered)
            weights_[one.number] = std::uint64_t(std::llround(receivers_.shares[one.receiver] * unit_));
    }

    void begin(Work& work, const Tile& tile, std::size_t sets) const {
        work.sums.begin(sets, tile.blocks.numbers(), casters_, weights_);
    }

    void sweep(const Tile& tile, std::size_t sets) {
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, batches_.size(), [&](std::size_t batch) {
            if (stop_.stop_requested()) return;
            Work& work = works_.local();
            if (!work.sums.begun()) begin(work, tile, sets);
            if (casters_ == 0) sweep(tile, batches_[batch], work);
            for (std::size_t bin = batches_[batch].first; bin < batches_[batch].end && casters_ > 0; ++bin)
                rank(tile, bin, work);
            const double share = double(++done) / double(batches_.size());
            progress_.report((double(receiversDone_) + share * double(tile.blocks.receivers())) /
                                 double(receivers_.cells.size()),
                             NM_TEXT("sweeping horizons"));
        });
    }

    void sweep(const Tile& tile, const BatchRange& batch, Work& work) {
        work.codes.resize(std::max(work.codes.size(), batch.size()));
        for (auto& codes : work.codes) codes.resize(tile.blocks.numbers());
        const auto take = [&](std::size_t bin, std::size_t i, const HorizonCode* swept, bool swapped) {
            writeBlock(swept, tile.blocks, tile.blocks.blocks()[i], swapped, work.codes[bin].data());
        };
        work.sweep.run(makeMapScene(tile), std::span(bins_).subspan(batch.first, batch.size()), take, stop_);
        for (std::size_t bin = 0; bin < batch.size() && !stop_.stop_requested(); ++bin)
            add(tile, batch.first + bin, work.codes[bin], work);
    }

    void add(const Tile& tile, std::size_t bin, std::span<const HorizonCode> codes, Work& work) {
        work.sums.add(tables_[bin], codes);
        if (!overhangs_.empty())
            work.sums.add(tables_[bin], codes,
                          work.overhangs.intervals(viewOf(tile, bins_[bin]), codes, stop_));
    }

    // Intervals below the horizon count too if their building may make that horizon.
    void rank(const Tile& tile, std::size_t bin, Work& work) {
        work.ranks.clear(tile.blocks.numbers());
        const auto take = [&](std::size_t i, const AttributedCodes* swept, bool swapped) {
            if (swept != nullptr) work.ranks.write(*swept, tile.blocks, tile.blocks.blocks()[i], swapped);
        };
        work.sweep.runAttributed(makeMapScene(tile), bins_[bin], take, stop_);
        if (stop_.stop_requested()) return;
        work.sums.add(tables_[bin], work.ranks);
        if (!overhangs_.empty())
            work.sums.add(
                tables_[bin], work.ranks,
                work.owned.intervals(overhangs_, viewOf(tile, bins_[bin]), work.ranks.others, stop_));
    }

    [[nodiscard]] TileScene makeMapScene(const Tile& tile) const {
        return {walls_, tile.blocks, tile.grounds, receivers_.grid.cellM};
    }

    [[nodiscard]] OverhangView viewOf(const Tile& tile, const SweptBin& bin) const {
        return {overhangList_, tile.overhangs, bin.away, bin.lowest, receivers_.grid.cellM};
    }

    // Whole numbers of steps: their order does not matter.
    void addCells(const std::vector<NumberedReceiver>& numbered, ShadowBreakdown& breakdown) const {
        tbb::parallel_for(std::size_t{0}, breakdown.minutes.size(), [&](std::size_t set) {
            std::vector<float>& minutes = breakdown.minutes[set];
            for (const Work& work : works_) {
                const auto steps = work.sums.cells(set);
                for (const NumberedReceiver& one : numbered)
                    minutes[one.receiver] += float(steps[one.number]);
            }
        });
    }

    void addCasters(ShadowBreakdown& breakdown, double minM2AStep) {
        for (std::uint32_t caster = 0; caster < casters_; ++caster) {
            BuildingShadow shadow = shadowOf(caster, breakdown.sets.names.size(), minM2AStep);
            if (std::ranges::all_of(shadow.attributedMinM2, [](double minM2) { return minM2 == 0; }))
                continue;
            if (caster == walls_.terrainNumber)
                breakdown.terrain = std::move(shadow);
            else
                breakdown.buildings.push_back(std::move(shadow));
        }
    }

    BuildingShadow shadowOf(std::uint32_t caster, std::size_t sets, double minM2AStep) {
        BuildingShadow shadow{caster, std::vector<double>(sets), std::vector<double>(sets)};
        for (const Work& work : works_)
            for (std::size_t set = 0; set < sets; ++set) {
                shadow.attributedMinM2[set] += double(work.sums.attributed(caster, set)) * minM2AStep;
                shadow.soleMinM2[set] += double(work.sums.sole(caster, set)) * minM2AStep;
            }
        return shadow;
    }

    const WallList& walls_;
    std::span<const OverhangShapes> overhangs_;
    OverhangList overhangList_;
    std::size_t casters_;  // buildings and the terrain; 0: no attribution
    const Receivers& receivers_;
    std::vector<SweptBin> bins_;
    std::vector<BatchRange> batches_;
    std::vector<SetTables> tables_;
    bool weighs_;                         // receivers count by their shares in the sums of buildings
    double unit_;                         // whole numbers that stand for a share of 1
    std::vector<std::uint64_t> weights_;  // of the tile's numbers; empty: 1 each
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    tbb::enumerable_thread_specific<Work> works_;
};

ShadowBreakdown blank(const Receivers& receivers, const SunSteps& sun, const StepSets& sets,
                      const BinnedSun& binned) {
    ShadowBreakdown breakdown{receivers.grid, sets, sets.sunlitMinutes(sun), receivers.cells, {}, {}, {}, {}};
    breakdown.engine =
        fmt::format("Horizon sweep: {}, one sweep for all months and intervals", formatText(binned));
    breakdown.shares = receivers.shares;
    breakdown.minutes.assign(sets.names.size(), std::vector<float>(receivers.cells.size()));
    return breakdown;
}

}  // namespace

Result<ShadowBreakdown> computeHorizonBreakdown(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const StepSets& sets,
                                                const BreakdownSettings& settings, Progress& progress,
                                                std::stop_token stop) {
    if (const auto able = checkSweepSettings(settings.sweep); !able) return tl::make_unexpected(able.error());
    OverhangParts overhangs;
    const WallList walls =
        collectStandingObstacles(city, findBuildingsInReach(city, receivers, sun), receivers, overhangs);
    const auto shapes = makeOverhangShapes(overhangs, receivers.grid, walls.datumM);
    if (!shapes) return tl::make_unexpected(shapes.error());
    const BinnedSun binned = binSun(sun, settings.sweep);
    ShadowBreakdown breakdown = blank(receivers, sun, sets, binned);
    Breakdown work(walls, *shapes, receivers, binned, sets, settings.byBuilding, progress, std::move(stop));
    if (const auto done = work.run(breakdown, sun.stepMinutes); !done)
        return tl::make_unexpected(done.error());
    return breakdown;
}

}  // namespace noonmark
