#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// The steps of a period, each assigned to one of several sets: months, hours of the day, intervals of equal
/// weight. Any sum of steps weighted per set follows from the sums of the sets.
struct StepSets {
    std::vector<std::string> names;
    std::vector<std::uint16_t> ofStep;  ///< index of each step's set, in time order

    /// Sunlit minutes of each set.
    [[nodiscard]] std::vector<double> sunlitMinutes(const SunSteps& sun) const;

    /// The steps of one set as a period of its own, with only those days that contain some of them.
    [[nodiscard]] SunSteps stepsOf(std::size_t set, const SunSteps& sun) const;
};

/// All steps in one set, "all".
StepSets makeOneSet(const SunSteps& sun);

/// "2026-01", "2026-02", ...: the months of the period, by the date of each day.
StepSets monthsOf(const SunSteps& sun);

}  // namespace noonmark
