#pragma once

#include <chrono>
#include <optional>

#include "core/sun/solar_position.h"

namespace noonmark {

/// When the sun counts as up.
enum class SunriseRule {
    upperLimb,  ///< centre at true altitude -0.833 deg: the upper limb seen on a flat horizon (almanacs)
    centre,     ///< centre at true altitude 0 deg: geometric
};

enum class DayKind { ordinary, polarDay, polarNight };

/// Sunrise, transit and sunset of one civil day.
struct SunEvents {
    DayKind kind = DayKind::ordinary;
    std::optional<Instant> sunrise;  ///< none on polar days and nights
    std::optional<Instant> sunset;   ///< the sunset that follows the transit
    Instant transit;                 ///< highest point of the day
};

/// Events around the transit of the civil day that begins at `localMidnight` (UTC instant of 0:00 local time). Within 1 s of NREL SPA.
SunEvents sunEvents(const Observer& observer, Instant localMidnight, SunriseRule rule);

}  // namespace noonmark
