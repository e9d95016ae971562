#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "core/sun/civil_time.h"
#include "core/sun/solar_position.h"
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

/// How a rule counts the hours of a day.
enum class ClockKind {
    civil,      ///< wall clock, with daylight saving
    standard,   ///< wall clock without daylight saving, all year
    fixed,      ///< a fixed offset from UTC
    trueSolar,  ///< 12:00 is the sun's passage through the meridian of the site
};

struct ClockSettings {
    ClockKind kind = ClockKind::civil;
    double offsetHours = 0;  ///< of `fixed`: local time minus UTC, -14 to 14
    bool operator==(const ClockSettings&) const = default;
};

/// Turns times of a day into instants and back. Standard time is the smaller of the zone's offsets on 1
/// January and 1 July of the date's year. Immutable.
class DayClock {
public:
    /// `ephemeris` must cover the days asked for, with a day before and after; only true solar time uses it.
    DayClock(ClockSettings settings, Zone zone, std::shared_ptr<const Ephemeris> ephemeris, double lonDeg);

    /// The instant of a time of day, minutes since midnight, 0 to 1440. True solar time to 0.1 s.
    [[nodiscard]] Instant instantAt(CivilDate date, double minutes) const;

    /// Minutes since the midnight at which `date` begins.
    [[nodiscard]] double minutesOf(CivilDate date, Instant at) const;

    /// "09:31", rounded to the minute
    [[nodiscard]] std::string timeText(CivilDate date, Instant at) const;

    /// "America/New_York, standard time", "true solar time", "UTC+09:00"
    [[nodiscard]] std::string text() const;

private:
    [[nodiscard]] std::chrono::seconds standardOffset(CivilDate date) const;
    [[nodiscard]] Instant solarInstant(CivilDate date, double minutes) const;

    ClockSettings settings_;
    Zone zone_;
    std::shared_ptr<const Ephemeris> sun_;
    double lonDeg_;
};

}  // namespace noonmark
