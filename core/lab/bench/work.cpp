#include "core/lab/bench/work.h"

#include <fmt/format.h>

namespace noonmark::bench {

namespace {

std::string describe(const Extent& extent) {
    const Extent full;
    return fmt::format(
        "Quick: {} of {} random hours, {} of {} places and {} of {} days with {:g} of {:g} hours; runs of "
        "more than {:g} s are not repeated, runs of more than {:g} s are extrapolated or left out; the "
        "graph's errors on {} receivers at each place; of other settings, places, days and resolutions as "
        "many as fit into {:g} s.",
        extent.hours, full.hours, extent.positions, full.positions, extent.days, full.days, extent.hoursADay,
        full.hoursADay, extent.onceAboveS, extent.neverAboveS, extent.graphReceivers, extent.budgetS);
}

}  // namespace

Extent makeFullExtent() { return {}; }

Extent makeQuickExtent() {
    Extent quick;
    quick.hours = 8;
    quick.graphReceivers = 25'000;
    quick.positions = 2;
    quick.days = 2;
    quick.resolutions = {256, 512, 1024, 2048};
    quick.dayCounts = {1, 30, 365};
    quick.binsDeg = {0.25, 0.5, 0.7, 1, 2};
    quick.factors = {0.5, 1, 2};
    quick.hoursADay = 1;
    quick.budgetS = 250;
    quick.onceAboveS = 0.3;
    quick.neverAboveS = 12;
    quick.sampleReceivers = 2000;
    quick.words = describe(quick);
    return quick;
}

}  // namespace noonmark::bench
