#pragma once

#include <span>
#include <stop_token>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// The part of one day in which the sun is measured, for days that no Period describes.
struct DayHours {
    CivilDate date;
    Instant from;
    double minutes = 0;  ///< 0 or less: the day has no steps
};

struct StepRule {
    double stepMinutes = 1;  ///< requested step, above 0
    bool refraction = true;  ///< true: the apparent sun; false: the geometric sun
    Degrees minAltitude{};   ///< steps with the sun at or below it are left out; 0 to 90
};

/// The sun in the windows of chosen days, which are in time order; the same division into steps. Error: an
/// observer out of range, a day outside 1900 to 2100, more than 50 million steps, or cancelled().
Result<SunSteps> computeSunSteps(std::span<const DayHours> windows, const StepRule& rule,
                                 const Observer& observer, const std::stop_token& stop = {});

}  // namespace noonmark
