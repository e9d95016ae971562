#pragma once

#include <chrono>
#include <optional>

#include "core/sun/solar_position.h"

namespace noonmark {

/// Definition of sunrise and sunset.
enum class SunriseRule {
    /// Centre at -0.833 deg, from the earth's centre: upper limb on a flat horizon, as in almanacs. The 0.567
    /// deg of refraction in it change in proportion where the air is thinner or denser than the default one.
    upperLimb,
    centre,  ///< centre at true altitude 0 deg, from the observer: geometric
};

enum class DayKind { ordinary, polarDay, polarNight };

/// Sunrise, transit and sunset of one civil day.
struct SunEvents {
    DayKind kind = DayKind::ordinary;
    /// None on polar days and nights, and if the sun was already up throughout the night before.
    std::optional<Instant> sunrise;
    std::optional<Instant> sunset;  ///< the sunset after the transit; none if the sun stays up
    Instant transit;  ///< crossing of the meridian; within seconds of the highest point of the day
};

/// Events around the transit that is nearest to noon of the civil day that begins at `localMidnight` (UTC
/// instant of 0:00 local time): sunrise in the 12 h before it, sunset in the 12 h after. On the first and
/// last day of midnight sun one of them is missing and the day counts as ordinary. Within 1 s of NREL SPA.
/// About 0.2 ms. `horizonDip`: how far the horizon lies below the level, for the upper limb only.
SunEvents computeSunEvents(const Observer& observer, Instant localMidnight, SunriseRule rule,
                           Degrees horizonDip = {0});

/// The same for many days of one place: `ephemeris` must cover 1 day before the first midnight to 2 days
/// after the last. About 10 us.
SunEvents computeSunEvents(const Ephemeris& ephemeris, Instant localMidnight, SunriseRule rule,
                           Degrees horizonDip = {0});

/// Altitude of the disc's centre, from the earth's centre, at sunrise and sunset under a level horizon.
double computeSunriseAltitudeDeg(SunriseRule rule, double airDensity);

/// Dip of a sea horizon for an eye `aboveHorizonM` metres above the sea, with the usual refraction: 1.76'
/// times the root of the height (Nautical Almanac).
Degrees computeHorizonDip(double aboveHorizonM);

}  // namespace noonmark
