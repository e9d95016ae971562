#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/horizon/azimuth_bins.h"

namespace noonmark {

/// A step of the period, in time order.
struct TimedStep {
    StepPlace place;
    bool startsRun = false;  ///< a new day, or steps are missing before it
};

std::vector<TimedStep> timedSteps(const SunSteps& sun, const BinnedSun& binned);

/// What several days may have in common at most while their suns cross one bin.
struct SharedVisit {
    std::uint16_t bin = 0;
    HorizonCode lowestSun = 0;  ///< of all those days: a horizon that does not hide it hides none
    std::int16_t steps = 0;     ///< most steps of one of the days
    bool endsRun = true;        ///< whether light here ends the run of every day
};

/// Some consecutive days, which look much alike, and one day that is at least as dark as each of them: the
/// longest run in shadow there is a bound for theirs.
struct DayGroup {
    std::uint32_t first = 0, end = 0;  ///< steps
    std::uint32_t longestDay = 0;      ///< steps
    std::vector<SharedVisit> visits;
};

/// Days in groups of up to `daysAGroup`, in time order. `steps`: the first one starts a run.
std::vector<DayGroup> dayGroups(std::span<const TimedStep> steps, int daysAGroup);

}  // namespace noonmark
