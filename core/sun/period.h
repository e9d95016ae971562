#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/sun/civil_time.h"
#include "core/sun/sun_events.h"

namespace noonmark {

/// The hours of a day counted from the sun: sunrise + afterSunrise to sunset - beforeSunset. All of them
/// count, whatever the step.
struct SolarWindow {
    std::chrono::minutes afterSunrise{0};
    std::chrono::minutes beforeSunset{0};
    SunriseRule rule = SunriseRule::upperLimb;
    bool operator==(const SolarWindow&) const = default;
};

/// The days and hours of a study. Ranges are checked by `checked`.
struct Period {
    CivilDate start{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    int days = 1;                       ///< 1 to 3660
    std::chrono::minutes from{9 * 60};  ///< wall clock, 0 to 24 h; ignored with a solar window
    double hours = 6;                   ///< a day, 0 to 24; 0 = one instant; ignored with a solar window
    /// 1/60 to 240: what is asked for. Whole steps of nearly this length fill a day's hours (SunSteps).
    double stepMinutes = 1;
    std::optional<SolarWindow> window;
    std::string zone = "UTC";  ///< IANA name
    bool refraction = true;    ///< the sun as seen (true) or geometric (false)
    bool operator==(const Period&) const = default;
};

/// The period itself, or what is out of range.
Result<Period> checked(const Period& period);

/// "2026-03-21, 1 day, 09:00 for 6 h, every 1 min, America/New_York"
std::string textOf(const Period& period);

/// "sunrise+1.5h..sunset-1.5h"
std::string textOf(const SolarWindow& window);

/// "sunrise+1.5h..sunset-1.5h", "sunrise-30m..sunset", "+1h..-1h"; whole minutes, at most 12 h. Without a
/// sign hours count into the day: "90m..90m" begins after sunrise and ends before sunset. The rule is that of
/// the upper limb.
Result<SolarWindow> parseSolarWindow(std::string_view text);

}  // namespace noonmark
