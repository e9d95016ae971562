#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/sun/civil_time.h"
#include "core/sun/sun_paths.h"

namespace noonmark {

/// A daily window relative to the sun: from sunrise + afterSunrise to sunset - beforeSunset. The whole window
/// counts, whatever the step.
struct SolarHours {
    std::chrono::minutes afterSunrise{0};
    std::chrono::minutes beforeSunset{0};
    SunriseRule rule = SunriseRule::upperLimb;
    bool operator==(const SolarHours&) const = default;
};

/// The days and hours of a study. validate() checks the ranges.
struct Period {
    CivilDate start{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    int days = 1;                       ///< 1 to 3660
    std::chrono::minutes from{9 * 60};  ///< wall clock, 0 to 24 h; ignored with a solar window
    double hours = 6;                   ///< per day, 0 to 24; 0 = one instant; ignored with a solar window
    /// Requested step, 1/60 to 240. The hours of a day are divided into whole steps of nearly this length
    /// (SunSteps).
    double stepMinutes = 1;
    std::optional<SolarHours> window;
    std::string zone = "UTC";  ///< IANA name
    bool refraction = true;    ///< true: the apparent sun; false: the geometric sun
    bool operator==(const Period&) const = default;
};

/// The period itself, or an error that names the value out of range.
Result<Period> validate(const Period& period);

/// "2026-03-21, 1 day, 09:00 for 6 h, every 1 min, America/New_York"
std::string formatText(const Period& period);

/// "sunrise+1.5h..sunset-1.5h"
std::string formatText(const SolarHours& window);

/// Parses "sunrise+1.5h..sunset-1.5h", "sunrise-30m..sunset", "+1h..-1h"; whole minutes, at most 12 h. A
/// value without a sign shortens the window: "90m..90m" begins after sunrise and ends before sunset. The
/// sunrise rule is upperLimb.
Result<SolarHours> parseSolarHours(std::string_view text);

}  // namespace noonmark
