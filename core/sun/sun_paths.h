#pragma once

#include <array>
#include <chrono>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sun/civil_time.h"
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

/// Dip of a sea horizon for an eye `aboveHorizonM` metres above the sea, with standard refraction: 1.76'
/// times the root of the height (Nautical Almanac).
Degrees computeHorizonDip(double aboveHorizonM);

/// Where and when the sun's paths are asked for.
struct SunPathQuestion {
    Observer observer;
    std::string zone = "UTC";  ///< IANA name; days begin at its midnight
    std::chrono::year year{2026};
    /// Local time minus UTC of the clock that the hour lines show, the same all year: where clocks change, a
    /// line of the wall clock would be broken in two.
    std::chrono::seconds clockOffset{0};
    bool refraction = true;  ///< true: the apparent sun; false: the geometric sun
    bool operator==(const SunPathQuestion&) const = default;
};

/// A line on the sky above the horizon: unit vectors in the frame of the geometry, in the order of time.
struct SunCurve {
    std::vector<glm::dvec3> towards;
    bool closed = false;  ///< the sun does not set: the last direction is followed by the first
};

/// The lines of a sun path diagram. A line that the horizon cuts is several curves; one below it has none.
struct SunPaths {
    std::array<std::vector<SunCurve>, 12> months;  ///< path of the 21st of each month, January first
    /// The sun at each full hour of the clock, 0 to 23, through the year: a figure of eight (analemma).
    std::array<std::vector<SunCurve>, 24> hours;
};

/// Directions are 10 minutes apart on paths, 5 days on hour lines; ends at the horizon are interpolated, off
/// by up to half a degree. Error: an unknown zone, an observer out of range, a year outside 1900 to 2100.
/// About 7 ms.
Result<SunPaths> computeSunPaths(const SunPathQuestion& question);

/// The path of one day, of any year in the range. About 0.2 ms.
Result<std::vector<SunCurve>> computeSunPath(const SunPathQuestion& question, CivilDate date);

}  // namespace noonmark
