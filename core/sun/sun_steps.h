#pragma once

// The folder core/sun computes the sun of a study. Period (period.h) states days, hours and step; SunSteps
// (this file) is the resulting list of sun positions, and the only thing that engines know about time.
// Positions come from ERFA through apparent_sun.h, and are interpolated
// by Ephemeris (solar_position.h); sunrise and sunset from sun_paths.h; civil dates and time zones from
// civil_time.h.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/sun/period.h"

namespace noonmark {

/// The sun at one step of the period.
struct SunStep {
    glm::vec3 direction;    ///< unit vector towards the sun in the frame of the geometry; z > 0
    float azimuthDeg = 0;   ///< at the observer: from true north, clockwise, 0 <= azimuth < 360
    float altitudeDeg = 0;  ///< at the observer, > 0; with refraction if the period includes it
    /// number of the step in its day's window; a gap between slots ends a continuous run
    std::int32_t slot = 0;
    Instant at;  ///< the beginning of the step
};

/// One day of the period: its steps are [first, first + count).
struct SunDay {
    CivilDate date;
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0 on a polar night, or if the window is empty
    /// steps of the window that are omitted because the sun is below the horizon
    std::uint32_t belowHorizon = 0;
};

/// The sun over a period, and the only thing that engines know about time. Steps are in time order.
///
/// The hours of each day are divided into whole steps of equal length, as near to the requested step as
/// possible (at least one step): n = round(hours / step); step k stands for the half-open interval [from + k
/// hours / n, from + (k + 1) hours / n) and has the sun of its beginning. A solar window of 375.9 min has 376
/// steps of 59.98 s at a step of 1 min, and 6 of 62.65 min at 60. Every step counts `stepMinutes`, the mean
/// over all days, so that the steps of the period add up to its hours and no time is dropped. Hours that the
/// requested step divides have exactly that step, and a single day is exact; over days of several lengths a
/// day's steps may add up to half a step more or less than its hours (`maxOffADayMin`). A day with hours = 0
/// has one step of 1 min.
struct SunSteps {
    double stepMinutes = 1;  ///< minutes that each step counts
    std::vector<SunStep> steps;
    std::vector<SunDay> days;  ///< all days of the period, in order
    std::size_t belowHorizon = 0;
    /// Number of steps of the requested period with the sun above the observer's horizon, but below the
    /// horizontal plane of the geometry's frame: far from the origin the terrain's drop tilts that plane
    /// against the horizon. Their direction is moved into the plane.
    std::size_t levelled = 0;
    double countedMinutes =
        0;                     ///< hours of all days together, including times with the sun below the horizon
    double maxOffADayMin = 0;  ///< largest difference between a day's hours and the sum of its steps

    [[nodiscard]] std::size_t dayCount() const { return days.size(); }
    /// Minutes of the whole period with the sun above the horizon: the denominator of every share of time.
    [[nodiscard]] double sunlitMinutes() const { return double(steps.size()) * stepMinutes; }
};

/// Computes the sun as seen from `observer`, for the whole city, in the frame of the observer's
/// frameFromPlace. With fixed hours a day begins at `from` on the wall clock and lasts `hours` of elapsed
/// time, also across midnight and changes of DST. A solar window begins with its first step; if the sun does
/// not rise or set because it stays up, the window begins or ends with the civil day. Error: a period or
/// observer out of range, more than 50 million steps, or cancelled(). A year of 8 h days at one minute takes
/// some 40 ms of processor time, on all cores.
Result<SunSteps> computeSunSteps(const Period& period, const Observer& observer,
                                 const std::stop_token& stop = {});

/// The same; error where the sun is below the horizon at all steps.
Result<SunSteps> computeDaylightSteps(const Period& period, const Observer& observer,
                                      const std::stop_token& stop);

/// A period that consists of some days of `sun` (indices of SunSteps::days, in the order given). Steps below
/// the horizon are counted for these days only.
SunSteps chooseDays(const SunSteps& sun, std::span<const std::size_t> days);

}  // namespace noonmark
