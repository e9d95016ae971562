#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/attribution/sort_by_number.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

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

}  // namespace noonmark
