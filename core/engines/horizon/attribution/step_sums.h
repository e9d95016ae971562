#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/overhangs/overhang_intervals.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

/// Sorts by the receiver's number, and the items of one receiver by `less`. Uses a counting sort where that
/// is less work: O(items + numbers). Reuses its memory.
template <class T>
class NumberSort {
public:
    /// `numbers`: upper limit of all numbers. `numberOf(item)`: its number.
    template <class NumberOf, class Less>
    void run(std::vector<T>& items, std::size_t numbers, const NumberOf& numberOf, const Less& less) {
        if (items.size() < numbers / 8) {
            std::sort(items.begin(), items.end(), [&](const T& a, const T& b) {
                return numberOf(a) != numberOf(b) ? numberOf(a) < numberOf(b) : less(a, b);
            });
            return;
        }
        distribute(items, numbers, numberOf);
        std::uint32_t first = 0;
        for (std::size_t number = 0; number < numbers; first = ends_[number++])
            sortFew(items.begin() + first, items.begin() + ends_[number], less);
    }

private:
    template <class NumberOf>
    void distribute(std::vector<T>& items, std::size_t numbers, const NumberOf& numberOf) {
        ends_.assign(numbers + 1, 0);
        for (const T& item : items) ++ends_[numberOf(item) + 1];
        for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
        sorted_.resize(items.size());
        for (const T& item : items) sorted_[ends_[numberOf(item)]++] = item;
        std::swap(items, sorted_);
    }

    // A receiver has only a handful of items.
    static void sortFew(auto first, auto end, const auto& less) {
        if (end - first > 32) return std::sort(first, end, less);
        for (auto item = first; item != end; ++item)
            std::rotate(std::upper_bound(first, item, *item, less), item, item + 1);
    }

    std::vector<std::uint32_t> ends_;  // end of each number's items
    std::vector<T> sorted_;
};

/// An interval that the overhangs of one building hide from a receiver.
struct BuildingGap {
    std::uint32_t number, building;
    HorizonCode low, high;
};

/// Finds the intervals of each building separately. One per thread.
class BuildingGapFinder {
public:
    /// As OverhangSweep::intervals(). The intervals of a receiver ascend; those of one building are disjoint,
    /// those of different buildings may overlap. `shapes`: the overhangs of the view.
    std::span<const BuildingGap> intervals(std::span<const OverhangShapes> shapes, OverhangView view,
                                           std::span<const HorizonCode> horizons,
                                           const std::stop_token& stop);

private:
    OverhangSweep sweep_;
    std::vector<BuildingGap> gaps_;
    NumberSort<BuildingGap> sort_;
};

/// The occluders of one receiver at one azimuth.
struct AttributedView {
    std::uint32_t building;   ///< building that makes the horizon, if there is one
    HorizonCode code, other;  ///< the horizon, and the horizon without that building
    std::span<const BuildingGap> gaps;

    [[nodiscard]] bool stands(std::uint32_t who) const { return code != noHorizon && who == building; }
};

/// Calls visit(building, from, to) for the suns [from, to) that overhangs hide above the horizon. Suns hidden
/// by several buildings are attributed to the interval that begins lowest. Together the calls cover all suns
/// hidden by overhangs.
template <class Visit>
void forEachAttributed(const AttributedView& view, const Visit& visit) {
    forEachAdded(view.code, view.gaps,
                 [&](const BuildingGap& gap, HorizonCode from) { visit(gap.building, from, gap.high); });
}

/// Calls more(from, to) for everything that overhangs hide above the horizon, and less(from, to) for what
/// they would hide without `building`. The building's sole contribution is the difference, plus the height of
/// its horizon above the others' if it makes the horizon.
template <class More, class Less>
void forEachSole(const AttributedView& view, std::uint32_t building, const More& more, const Less& less) {
    forEachAdded(view.code, view.gaps,
                 [&](const BuildingGap& gap, HorizonCode from) { more(from, gap.high); });
    const auto foreign = [&](const BuildingGap& gap) { return gap.building != building; };
    forEachAdded(
        view.stands(building) ? view.other : view.code, view.gaps,
        [&](const BuildingGap& gap, HorizonCode from) { less(from, gap.high); }, foreign);
}

/// Calls visit(building) once for the building that makes the horizon and once for each other building with
/// overhangs there.
template <class Visit>
void forEachBuilding(const AttributedView& view, const Visit& visit) {
    if (view.code != noHorizon) visit(view.building);
    for (std::size_t i = 0; i < view.gaps.size(); ++i) {
        const std::uint32_t building = view.gaps[i].building;
        const auto same = [&](const BuildingGap& gap) { return gap.building == building; };
        if (!view.stands(building) && std::ranges::none_of(view.gaps.first(i), same)) visit(building);
    }
}

/// The steps of one bin in one set.
struct SetTable {
    std::size_t set;
    HiddenSuns hidden;
    std::vector<CountChange> suns;  ///< the same for many horizons at once
};
using SetTables = std::vector<SetTable>;

/// For each bin, the tables of the sets that have steps in it.
std::vector<SetTables> setTables(const BinnedSun& binned, const StepSets& sets);

/// Steps in shadow by set: one sum per number of a tile, and one per building.
class StepSums {
public:
    /// Begins another tile; the sums of buildings are kept. `buildings`: 0 if they are not needed. `weights`:
    /// what a step of each number counts in their sums; empty: 1. They outlive the tile.
    void begin(std::size_t sets, std::size_t numbers, std::size_t buildings,
               std::span<const std::uint64_t> weights = {});

    /// Adds the steps that the horizons of one bin hide, without buildings; flush() before cells(). `codes`:
    /// one per number.
    void add(const SetTables& tables, std::span<const HorizonCode> codes);
    /// Adds the steps that gaps hide above the horizons; `gaps`: sorted by number and altitude.
    void add(const SetTables& tables, std::span<const HorizonCode> codes, std::span<const Gap> gaps);

    /// The same with attribution to buildings.
    void add(const SetTables& tables, const AttributedTile& ranks);
    void add(const SetTables& tables, const AttributedTile& ranks, std::span<const BuildingGap> gaps);

    void flush();

    [[nodiscard]] std::size_t sets() const { return cells_.size(); }
    [[nodiscard]] bool begun() const { return !cells_.empty(); }
    [[nodiscard]] std::span<const std::uint32_t> cells(std::size_t set) const { return cells_[set]; }
    [[nodiscard]] std::uint64_t attributed(std::size_t building, std::size_t set) const {
        return attributed_[building * sets() + set];
    }
    [[nodiscard]] std::uint64_t sole(std::size_t building, std::size_t set) const {
        return sole_[building * sets() + set];
    }

private:
    /// Sums in 16 bits for as long as they cannot overflow: half of the memory that every bin goes through.
    struct ShortCells {
        std::vector<std::int16_t> sums;
        int maximum = 0;
    };

    template <class Weight>
    void addWeighed(const SetTables& tables, const AttributedTile& ranks, const Weight& weightOf);
    void add(const SetTables& tables, std::uint32_t number, const AttributedView& view);
    void flush(std::size_t set);

    std::vector<std::vector<std::uint32_t>> cells_;
    std::vector<ShortCells> short_;                 // by set
    std::vector<std::uint64_t> attributed_, sole_;  // index: building x sets + set
    std::span<const std::uint64_t> weights_;        // empty: 1 each
};

}  // namespace noonmark
