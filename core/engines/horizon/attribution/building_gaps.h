#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/attribution/sort_by_number.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

/// What the hanging parts of one building hide from a receiver.
struct BuildingGap {
    std::uint32_t number, building;
    HorizonCode low, high;
};

/// Intervals of each building for itself. One for each thread.
class BuildingGapFinder {
public:
    /// As OverhangSweep::intervals; of one receiver from below, those of one building disjoint, of several
    /// perhaps not. `shapes`: what is in the view.
    std::span<const BuildingGap> intervals(std::span<const OverhangShapes> shapes, OverhangView view,
                                           std::span<const HorizonCode> horizons,
                                           const std::stop_token& stop);

private:
    OverhangSweep sweep_;
    std::vector<BuildingGap> gaps_;
    NumberSort<BuildingGap> sort_;
};

/// One receiver at one azimuth: who stands before it, and what hangs.
struct AttributedView {
    std::uint32_t building;   ///< whose the horizon is, where there is one
    HorizonCode code, other;  ///< the horizon, and what it would be without that building
    std::span<const BuildingGap> gaps;

    [[nodiscard]] bool stands(std::uint32_t who) const { return code != noHorizon && who == building; }
};

/// Calls visit(building, from, to) for the suns [from, to) that what hangs hides above the horizon: where
/// several buildings hide the same, the one that begins lowest has it. All together are hidden.
template <class Visit>
void forEachAttributed(const AttributedView& view, const Visit& visit) {
    forEachAdded(view.code, view.gaps,
                 [&](const BuildingGap& gap, HorizonCode from) { visit(gap.building, from, gap.high); });
}

/// Calls more(from, to) for all that what hangs hides above the horizon and less(from, to) for what it still
/// would without a building. The difference and, where the horizon is the building's, what that is above the
/// others' is what the building alone hides.
template <class More, class Less>
void forEachSole(const AttributedView& view, std::uint32_t building, const More& more, const Less& less) {
    forEachAdded(view.code, view.gaps,
                 [&](const BuildingGap& gap, HorizonCode from) { more(from, gap.high); });
    const auto foreign = [&](const BuildingGap& gap) { return gap.building != building; };
    forEachAdded(
        view.stands(building) ? view.other : view.code, view.gaps,
        [&](const BuildingGap& gap, HorizonCode from) { less(from, gap.high); }, foreign);
}

/// Calls visit(building) once for whoever makes the horizon and all whose parts hang there.
template <class Visit>
void forEachBuilding(const AttributedView& view, const Visit& visit) {
    if (view.code != noHorizon) visit(view.building);
    for (std::size_t i = 0; i < view.gaps.size(); ++i) {
        const std::uint32_t building = view.gaps[i].building;
        const auto same = [&](const BuildingGap& gap) { return gap.building == building; };
        if (!view.stands(building) && std::ranges::none_of(view.gaps.first(i), same)) visit(building);
    }
}

}  // namespace noonmark
