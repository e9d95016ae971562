#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

/// A step of the period, in time order.
struct TimedStep {
    StepPlace place;
    bool startsRun = false;  ///< it is the first of a day, or steps are missing before it
};

std::vector<TimedStep> makeTimedSteps(const SunSteps& sun, const BinnedSun& binned);

/// The steps [first, end) of a day, or of a part of it without gaps.
struct DaySteps {
    std::uint32_t first = 0, end = 0;
    float declination = 0;  ///< sine; the sign may be reversed. Days of similar declination are similar
};

/// Sorted by declination, so that days equally far before and after a solstice are adjacent.
std::vector<DaySteps> sortDaysByDeclination(const SunSteps& sun, std::span<const TimedStep> steps);

/// An upper bound for several days while their suns cross one bin.
struct SharedVisit {
    std::uint16_t bin = 0;
    HorizonCode lowestSun = 0;  ///< lowest of all these days: a horizon that does not hide it hides no sun
    std::int16_t steps = 0;     ///< largest number of steps on one day
    bool endsRun = true;        ///< whether light in this bin ends the run on every day
};

/// Similar days, together with one synthetic day that is at least as dark as each of them: its longest run in
/// shadow is an upper bound for theirs.
struct DayGroup {
    std::vector<DaySteps> days;
    std::uint32_t longestDay = 0;  ///< steps
    std::vector<SharedVisit> visits;
};

/// How much the days of a group may differ.
struct Likeness {
    float declination;       ///< sine
    std::uint32_t mostDays;  ///< at least one
};

/// Groups days in their order. `days`: sorted by declination. The days of a group have at most 32,767 steps
/// in total.
std::vector<DayGroup> groupDays(std::span<const TimedStep> steps, std::span<const DaySteps> days,
                                const Likeness& likeness);

}  // namespace noonmark
