#include "core/accumulate/horizon_breakdown.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <new>

#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/horizon_case.h"
#include "core/accumulate/reach.h"

namespace noonmark {

namespace {

constexpr int tileSide = 512;

/// Sums of steps: for each set one a number, and for each building one a set.
struct StepSums {
    std::vector<std::vector<std::uint32_t>> cells;
    std::vector<std::uint64_t> attributed, sole;  // building x sets + set

    void begin(std::size_t sets, std::size_t numbers, std::size_t buildings) {
        cells.assign(sets, std::vector<std::uint32_t>(numbers));
        attributed.resize(sets * buildings);
        sole.resize(sets * buildings);
    }
};

/// The steps of one bin in one set.
struct SetTable {
    std::size_t set;
    HiddenSuns hidden;
};

// Tables of each bin for the sets that have steps there.
std::vector<std::vector<SetTable>> tablesOf(const BinnedSun& binned, const StepSets& sets) {
    std::vector<std::vector<std::vector<HorizonCode>>> suns(binned.bins.size());
    for (auto& bin : suns) bin.resize(sets.names.size());
    for (std::size_t i = 0; i < binned.places.size(); ++i)
        suns[binned.places[i].bin][sets.ofStep[i]].push_back(binned.places[i].sun);
    std::vector<std::vector<SetTable>> tables(suns.size());
    for (std::size_t bin = 0; bin < suns.size(); ++bin)
        for (std::size_t set = 0; set < suns[bin].size(); ++set) {
            std::ranges::sort(suns[bin][set]);
            if (!suns[bin][set].empty()) tables[bin].push_back({set, HiddenSuns(suns[bin][set])});
        }
    return tables;
}

class Breakdown {
public:
    Breakdown(const WallList& walls, const Receivers& receivers, const BinnedSun& binned,
              const StepSets& sets, bool byBuilding, Progress& progress, std::stop_token stop)
        : walls_(walls),
          casters_(byBuilding ? walls.terrainNumber + 1 : 0),
          receivers_(receivers),
          binned_(binned),
          tables_(tablesOf(binned, sets)),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<void> run(ShadowBreakdown& breakdown, double stepMinutes) {
        for (const TileBox& box : tilesOf(receivers_.grid, tileSide)) {
            const ReceiverBlocks blocks(receivers_, box);
            if (blocks.receivers() == 0) continue;
            for (StepSums& sums : sums_) sums.begin(breakdown.sets.names.size(), blocks.numbers(), casters_);
            sweep(blocks, {receivers_, blocks, walls_.datumM}, breakdown.sets.names.size());
            if (stop_.stop_requested()) return cancelled();
            for (const StepSums& sums : sums_) addCells(blocks, sums, breakdown);
            receiversDone_ += blocks.receivers();
        }
        for (auto& minutes : breakdown.minutes)
            for (float& value : minutes) value = float(double(value) * stepMinutes);
        addCasters(breakdown, stepMinutes * receivers_.grid.cellAreaM2());
        return {};
    }

private:
    void sweep(const ReceiverBlocks& blocks, const BlockGrounds& grounds, std::size_t sets) {
        std::atomic<std::size_t> done{0};
        tbb::parallel_for(std::size_t{0}, binned_.bins.size(), [&](std::size_t bin) {
            if (stop_.stop_requested()) return;
            StepSums& sums = sums_.local();
            if (sums.cells.empty()) sums.begin(sets, blocks.numbers(), casters_);
            sweepBin(blocks, grounds, bin, sums);
            const double share = double(++done) / double(binned_.bins.size());
            progress_.report((double(receiversDone_) + share * double(blocks.receivers())) /
                                 double(receivers_.cells.size()),
                             "sweeping horizons");
        });
    }

    void sweepBin(const ReceiverBlocks& blocks, const BlockGrounds& grounds, std::size_t number,
                  StepSums& sums) {
        const AzimuthBin& bin = binned_.bins[number];
        const ShadowAxes axes(bin.away);
        SquareSweep& squares = squares_.local();
        squares.beginAll(walls_, bin.away, extentOf(blocks.box(), axes), bin.lowest(), receivers_.grid.cellM,
                         stop_);
        for (std::size_t i = 0; i < blocks.blocks().size() && !stop_.stop_requested(); ++i) {
            const ReceiverBlocks::Block& block = blocks.blocks()[i];
            const ReceiverBlocks::Masks& masks = blocks.masks(i, axes.swapped);
            const BlockGround ground = grounds.of(i, axes.swapped);
            const std::uint8_t* places = blocks.places(block, axes.swapped);
            if (casters_ > 0) {
                if (const RankedCodes* ranked = squares.rankedCodes(block, masks, ground))
                    add(block, places, *ranked, tables_[number], sums);
            } else if (const HorizonCode* codes = squares.codes(block, masks, ground)) {
                for (const SetTable& table : tables_[number])
                    for (std::uint32_t n = 0; n < block.count; ++n)
                        sums.cells[table.set][block.first + n] += table.hidden(codes[places[n]]);
            }
        }
    }

    static void add(const ReceiverBlocks::Block& block, const std::uint8_t* places, const RankedCodes& ranked,
                    const std::vector<SetTable>& tables, StepSums& sums) {
        const std::size_t sets = sums.cells.size();
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const std::size_t place = places[n];
            if (ranked.codes[place] == noHorizon) continue;
            const std::size_t of = std::size_t(ranked.buildings[place]) * sets;
            for (const SetTable& table : tables) {
                const std::uint32_t hidden = table.hidden(ranked.codes[place]);
                sums.cells[table.set][block.first + n] += hidden;
                sums.attributed[of + table.set] += hidden;
                sums.sole[of + table.set] += hidden - table.hidden(ranked.others[place]);
            }
        }
    }

    static void addCells(const ReceiverBlocks& blocks, const StepSums& sums, ShadowBreakdown& breakdown) {
        for (std::size_t set = 0; set < sums.cells.size(); ++set)
            for (std::size_t n = 0; n < blocks.numbers(); ++n)
                if (blocks.cell(n) != ReceiverBlocks::padding)
                    breakdown.minutes[set][blocks.cell(n)] += float(sums.cells[set][n]);
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
        for (const StepSums& sums : sums_)
            for (std::size_t set = 0; set < sets; ++set) {
                shadow.attributedMinM2[set] += double(sums.attributed[caster * sets + set]) * minM2AStep;
                shadow.soleMinM2[set] += double(sums.sole[caster * sets + set]) * minM2AStep;
            }
        return shadow;
    }

    const WallList& walls_;
    std::size_t casters_;  // buildings and the terrain; 0: nobody asks
    const Receivers& receivers_;
    const BinnedSun& binned_;
    std::vector<std::vector<SetTable>> tables_;
    Progress& progress_;
    std::stop_token stop_;
    std::size_t receiversDone_ = 0;
    tbb::enumerable_thread_specific<SquareSweep> squares_;
    tbb::enumerable_thread_specific<StepSums> sums_;
};

ShadowBreakdown blank(const Receivers& receivers, const SunSteps& sun, const StepSets& sets) {
    ShadowBreakdown breakdown{receivers.grid, sets, sets.sunlitMinutes(sun), {}, {}};
    std::vector<float> none(receivers.grid.size(), std::numeric_limits<float>::quiet_NaN());
    for (const std::uint32_t cell : receivers.cells) none[cell] = 0;
    breakdown.minutes.assign(sets.names.size(), none);
    return breakdown;
}

}  // namespace

Result<ShadowBreakdown> horizonBreakdown(const City& city, const Receivers& receivers, const SunSteps& sun,
                                         const StepSets& sets, const BreakdownSettings& settings,
                                         Progress& progress, std::stop_token stop) try {
    if (const auto able = checkBinWidth(settings.sweep.binDeg); !able)
        return tl::make_unexpected(able.error());
    OpenParts open;
    const WallList walls = standingIn(city, buildingsInReach(city, receivers, sun), receivers, open);
    if (!open.empty())
        return failure("Months and contributions are of what stands on the ground, and a part in reach hangs",
                       open.front()->sourceId, "Leave it out, or use other engines without them");
    const BinnedSun binned = binnedSun(sun, settings.sweep.binDeg);
    ShadowBreakdown breakdown = blank(receivers, sun, sets);
    Breakdown work(walls, receivers, binned, sets, settings.byBuilding, progress, std::move(stop));
    if (const auto done = work.run(breakdown, sun.stepMinutes); !done)
        return tl::make_unexpected(done.error());
    return breakdown;
} catch (const std::bad_alloc&) {
    return failure("There is not enough memory for this study", "horizon sweep",
                   "Choose a smaller region or larger cells");
}

}  // namespace noonmark
