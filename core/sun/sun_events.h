#pragma once

#include <chrono>
#include <optional>

#include "core/sun/solar_position.h"

namespace noonmark {

/// When the sun counts as up.
enum class SunriseRule {
    upperLimb,  ///< centre at -0.833 deg, from the earth's centre: the upper limb on a flat horizon
                ///< (almanacs)
    centre,     ///< centre at true altitude 0 deg, from the observer: geometric
};

enum class DayKind { ordinary, polarDay, polarNight };

/// Sunrise, transit and sunset of one civil day.
struct SunEvents {
    DayKind kind = DayKind::ordinary;
    std::optional<Instant>
        sunrise;  ///< none on polar days and nights, and where the sun was up all night before
    std::optional<Instant> sunset;  ///< the sunset that follows the transit; none where the sun then stays up
    Instant transit;  ///< crosses the meridian: the highest point of the day, but for some seconds
};

/// Events around the transit that is nearest to noon of the civil day that begins at `localMidnight` (UTC
/// instant of 0:00 local time): sunrise in the 12 h before it, sunset in the 12 h after. On the first and
/// last day of midnight sun one of them is missing and the day is ordinary. Within 1 s of NREL SPA. About 0.2
/// ms.
SunEvents computeSunEvents(const Observer& observer, Instant localMidnight, SunriseRule rule);

/// The same for many days of one place: `ephemeris` covers from 1 day before the first midnight to 2 days
/// after the last. About 10 us.
SunEvents computeSunEvents(const Ephemeris& ephemeris, Instant localMidnight, SunriseRule rule);

}  // namespace noonmark
