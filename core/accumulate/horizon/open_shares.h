#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/open_sweep.h"
#include "core/accumulate/horizon/sort_by_number.h"

namespace noonmark {

/// What the hanging parts of one building hide from a receiver.
struct OwnedGap {
    std::uint32_t number, building;
    HorizonCode low, high;
};

/// Intervals of each building for itself. One for each thread.
class OwnedGaps {
public:
    /// As OpenSweep::intervals; of one receiver from below, those of one building disjoint, of several
    /// perhaps not. `shapes`: what is in the view.
    std::span<const OwnedGap> intervals(std::span<const OpenShapes> shapes, OpenView view,
                                        std::span<const HorizonCode> horizons, const std::stop_token& stop);

private:
    OpenSweep sweep_;
    std::vector<OwnedGap> gaps_;
    NumberSort<OwnedGap> sort_;
};

/// One receiver at one azimuth: who stands before it, and what hangs.
struct OwnedView {
    std::uint32_t building;   ///< whose the horizon is, where there is one
    HorizonCode code, other;  ///< the horizon, and what it would be without that building
    std::span<const OwnedGap> gaps;

    [[nodiscard]] bool stands(std::uint32_t who) const { return code != noHorizon && who == building; }
};

/// Calls visit(building, from, to) for the suns [from, to) that what hangs hides above the horizon: where
/// several buildings hide the same, the one that begins lowest has it. All together are hidden.
template <class Visit>
void forEachAttributed(const OwnedView& view, const Visit& visit) {
    forEachAdded(view.code, view.gaps,
                 [&](const OwnedGap& gap, HorizonCode from) { visit(gap.building, from, gap.high); });
}

/// Calls more(from, to) for all that what hangs hides above the horizon and less(from, to) for what it still
/// would without a building. The difference and, where the horizon is the building's, what that is above the
/// others' is what the building alone hides.
template <class More, class Less>
void forEachSole(const OwnedView& view, std::uint32_t building, const More& more, const Less& less) {
    forEachAdded(view.code, view.gaps, [&](const OwnedGap& gap, HorizonCode from) { more(from, gap.high); });
    const auto foreign = [&](const OwnedGap& gap) { return gap.building != building; };
    forEachAdded(
        view.stands(building) ? view.other : view.code, view.gaps,
        [&](const OwnedGap& gap, HorizonCode from) { less(from, gap.high); }, foreign);
}

/// Calls visit(building) once for whoever makes the horizon and all whose parts hang there.
template <class Visit>
void forEachBuilding(const OwnedView& view, const Visit& visit) {
    if (view.code != noHorizon) visit(view.building);
    for (std::size_t i = 0; i < view.gaps.size(); ++i) {
        const std::uint32_t building = view.gaps[i].building;
        const auto same = [&](const OwnedGap& gap) { return gap.building == building; };
        if (!view.stands(building) && std::ranges::none_of(view.gaps.first(i), same)) visit(building);
    }
}

}  // namespace noonmark
