#include "core/engines/horizon/attribution/step_sums.h"

#include <tbb/parallel_for.h>

#include <limits>
#include <tuple>

namespace noonmark {

std::span<const BuildingGap> BuildingGapFinder::intervals(std::span<const OverhangShapes> shapes,
                                                          OverhangView view,
                                                          std::span<const HorizonCode> horizons,
                                                          const std::stop_token& stop) {
    gaps_.clear();
    for (const OverhangShapes& own : shapes) {
        const OverhangShapes* const one[]{&own};
        view.shapes = one;
        for (const Gap& gap : sweep_.intervals(view, horizons, stop))
            gaps_.push_back({gap.number, own.building, gap.low, gap.high});
    }
    sort_.run(
        gaps_, horizons.size(), [](const BuildingGap& gap) { return gap.number; },
        [](const BuildingGap& a, const BuildingGap& b) {
            return std::tie(a.low, a.building) < std::tie(b.low, b.building);
        });
    return gaps_;
}

std::vector<SetTables> setTables(const BinnedSun& binned, const StepSets& sets) {
    std::vector<std::vector<std::vector<HorizonCode>>> suns(binned.bins.size());
    for (auto& bin : suns) bin.resize(sets.names.size());
    for (std::size_t i = 0; i < binned.places.size(); ++i)
        suns[binned.places[i].bin][sets.ofStep[i]].push_back(binned.places[i].sun);
    std::vector<SetTables> tables(suns.size());
    tbb::parallel_for(std::size_t{0}, suns.size(), [&](std::size_t bin) {
        for (std::size_t set = 0; set < suns[bin].size(); ++set) {
            std::ranges::sort(suns[bin][set]);
            if (!suns[bin][set].empty())
                tables[bin].push_back({set, HiddenSuns(suns[bin][set]), findSunChanges(suns[bin][set], {})});
        }
    });
    return tables;
}

void StepSums::begin(std::size_t sets, std::size_t numbers, std::size_t buildings,
                     std::span<const std::uint64_t> weights) {
    weights_ = weights;
    cells_.resize(sets);
    for (auto& sums : cells_) sums.assign(numbers, 0);  // keeps the memory of the tile before
    short_.resize(sets);
    for (ShortCells& some : short_) {
        some.sums.assign(buildings == 0 ? numbers : 0, 0);
        some.maximum = 0;
    }
    attributed_.resize(sets * buildings);
    sole_.resize(sets * buildings);
}

void StepSums::add(const SetTables& tables, std::span<const HorizonCode> codes) {
    constexpr int maxShort = std::numeric_limits<std::int16_t>::max();
    for (const SetTable& table : tables)
        for (const CountChange& suns : table.suns) {
            ShortCells& some = short_[table.set];
            if (some.maximum + suns.maximum() > maxShort) flush(table.set);
            some.maximum += suns.maximum();
            suns.addTo(codes.data(), codes.size(), some.sums.data());
        }
}

void StepSums::flush(std::size_t set) {
    ShortCells& some = short_[set];
    if (some.maximum == 0) return;
    for (std::size_t i = 0; i < some.sums.size(); ++i) cells_[set][i] += std::uint32_t(int(some.sums[i]));
    std::ranges::fill(some.sums, std::int16_t{0});
    some.maximum = 0;
}

void StepSums::flush() {
    for (std::size_t set = 0; set < short_.size(); ++set) flush(set);
}

void StepSums::add(const SetTables& tables, std::span<const HorizonCode> codes, std::span<const Gap> gaps) {
    forEachReceiver(gaps, [&](std::span<const Gap> own) {
        const std::uint32_t number = own.front().number;
        for (const SetTable& table : tables)
            cells_[table.set][number] += countHidden(codes[number], own, table.hidden);
    });
}

template <class Weight>
void StepSums::addWeighed(const SetTables& tables, const AttributedTile& ranks, const Weight& weightOf) {
    for (std::size_t number = 0; number < ranks.codes.size(); ++number) {
        if (ranks.codes[number] == noHorizon) continue;
        const std::size_t of = std::size_t(ranks.buildings[number]) * sets();
        const std::uint64_t weight = weightOf(number);
        for (const SetTable& table : tables) {
            const std::uint32_t hidden = table.hidden(ranks.codes[number]);
            cells_[table.set][number] += hidden;
            attributed_[of + table.set] += weight * hidden;
            sole_[of + table.set] += weight * (hidden - table.hidden(ranks.others[number]));
        }
    }
}

void StepSums::add(const SetTables& tables, const AttributedTile& ranks) {
    if (weights_.empty())
        addWeighed(tables, ranks, [](std::size_t) { return std::uint64_t{1}; });
    else
        addWeighed(tables, ranks, [this](std::size_t number) { return weights_[number]; });
}

void StepSums::add(const SetTables& tables, const AttributedTile& ranks, std::span<const BuildingGap> gaps) {
    forEachReceiver(gaps, [&](std::span<const BuildingGap> own) {
        const std::uint32_t number = own.front().number;
        add(tables, number, {ranks.buildings[number], ranks.codes[number], ranks.others[number], own});
    });
}

void StepSums::add(const SetTables& tables, std::uint32_t number, const AttributedView& view) {
    const std::uint64_t weight = weights_.empty() ? 1 : weights_[number];
    for (const SetTable& table : tables) {
        const std::size_t set = table.set;
        const auto between = [&](HorizonCode from, HorizonCode to) {
            return table.hidden(to) - table.hidden(from);
        };
        forEachAttributed(view, [&](std::uint32_t building, HorizonCode from, HorizonCode to) {
            cells_[set][number] += between(from, to);
            attributed_[building * sets() + set] += weight * between(from, to);
        });
        forEachBuilding(view, [&](std::uint32_t building) {
            std::uint64_t& sole = sole_[building * sets() + set];
            forEachSole(
                view, building, [&](HorizonCode from, HorizonCode to) { sole += weight * between(from, to); },
                [&](HorizonCode from, HorizonCode to) { sole -= weight * between(from, to); });
        });
    }
}

}  // namespace noonmark
