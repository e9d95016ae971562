#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// The steps of a period, each in one of several sets: months, hours of the day, intervals of one weight. Any
/// weighted sum of steps with one weight a set follows from the sums of the sets.
struct StepSets {
    std::vector<std::string> names;
    std::vector<std::uint16_t> ofStep;  ///< one a step, in time order: index of its set

    /// Minutes of sunlit time in each set.
    [[nodiscard]] std::vector<double> sunlitMinutes(const SunSteps& sun) const;

    /// The steps of one set as a period of its own, of those days that have some.
    [[nodiscard]] SunSteps stepsOf(std::size_t set, const SunSteps& sun) const;
};

/// All steps in one set, "all".
StepSets makeOneSet(const SunSteps& sun);

/// "2026-01", "2026-02", ...: the months of the period, by the date of each day.
StepSets monthsOf(const SunSteps& sun);

}  // namespace noonmark
