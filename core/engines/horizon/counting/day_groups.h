#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

/// A step of the period, in time order.
struct TimedStep {
    StepPlace place;
    bool startsRun = false;  ///< a new day, or steps are missing before it
};

std::vector<TimedStep> makeTimedSteps(const SunSteps& sun, const BinnedSun& binned);

/// The steps [first, end) of a day, or of a part of it without a gap.
struct DaySteps {
    std::uint32_t first = 0, end = 0;
    float declination = 0;  ///< sine, to within its sign: days of like declination look alike
};

/// In order of declination: two days as long before and after a solstice stand beside one another.
std::vector<DaySteps> sortDaysByDeclination(const SunSteps& sun, std::span<const TimedStep> steps);

/// What several days may have in common at most while their suns cross one bin.
struct SharedVisit {
    std::uint16_t bin = 0;
    HorizonCode lowestSun = 0;  ///< of all those days: a horizon that does not hide it hides none
    std::int16_t steps = 0;     ///< most steps of one of the days
    bool endsRun = true;        ///< whether light here ends the run of every day
};

/// Some days, which look much alike, and one day that is at least as dark as each of them: the longest run in
/// shadow there is a bound for theirs.
struct DayGroup {
    std::vector<DaySteps> days;
    std::uint32_t longestDay = 0;  ///< steps
    std::vector<SharedVisit> visits;
};

/// How much days of a group may differ.
struct Likeness {
    float declination;       ///< sine
    std::uint32_t mostDays;  ///< at least one
};

/// Days in groups, in their order. `days`: by declination. A group's days have no more than 32,767 steps
/// together.
std::vector<DayGroup> groupDays(std::span<const TimedStep> steps, std::span<const DaySteps> days,
                                const Likeness& likeness);

}  // namespace noonmark
