#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <stop_token>
#include <vector>

#include "core/sun/period.h"

namespace noonmark {

/// The sun at one step of the period.
struct SunStep {
    glm::vec3 direction;    ///< unit vector towards the sun in the frame of the geometry; z > 0
    float azimuthDeg = 0;   ///< at the observer: from true north, clockwise, 0 <= azimuth < 360
    float altitudeDeg = 0;  ///< at the observer, > 0; with refraction if the period asks for it
    std::int32_t slot = 0;  ///< number of the step in its day's window; a gap between slots breaks a run
    Instant at;             ///< the beginning of the step
};

/// One day of the period: its steps are [first, first + count).
struct SunDay {
    CivilDate date;
    std::uint32_t first = 0;
    std::uint32_t count = 0;         ///< 0 on a polar night, or where the window is empty
    std::uint32_t belowHorizon = 0;  ///< steps of the window left out because the sun is not there
};

/// The sun over a period: the only thing that engines know of time. Steps in time order.
///
/// Whole steps fill the hours of each day, as many of equal length as come nearest to the step asked for (at
/// least one): n = round(hours / step), step k stands for the half-open interval [from + k hours / n, from +
/// (k + 1) hours / n) and has the sun of its beginning. A solar window of 375.9 min has 376 steps of 59.98 s
/// at a step of 1 min, and 6 of 62.65 min at 60. Every step counts `stepMinutes`: the mean over all days, so
/// that the period has the minutes of its hours and no time is dropped. Hours that the step divides have just
/// that step; a single day is exact; over days of several lengths one of them counts up to half a step more
/// or less than its hours (`mostOffADayMin`). A day with hours = 0 has one step of 1 min.
struct SunSteps {
    double stepMinutes = 1;  ///< what a step counts
    std::vector<SunStep> steps;
    std::vector<SunDay> days;  ///< all days of the period, in order
    std::size_t belowHorizon = 0;
    /// Of the steps of the period as it was asked for: above the observer's horizon, but below the plane of
    /// the geometry's frame, which the drop of the terrain tilts against it far from the origin. Taken in
    /// that plane.
    std::size_t levelled = 0;
    double windowMinutes = 0;   ///< of the hours of all days, with those that the sun is below the horizon
    double mostOffADayMin = 0;  ///< the day whose steps count least like its own hours

    [[nodiscard]] std::size_t dayCount() const { return days.size(); }
    /// Minutes of the whole period with the sun above the horizon: what a fraction of time is a fraction of.
    [[nodiscard]] double sunlitMinutes() const { return double(steps.size()) * stepMinutes; }
};

/// The sun is the one seen from `observer` over the whole city, in the frame that the observer names. With
/// fixed hours a day begins at `from` on the wall clock and lasts `hours` of elapsed time, over midnight and
/// changes of DST too. A solar window begins with its first step; where the sun does not rise or set because
/// it stays up, it begins or ends with the civil day. Error: a period or observer out of range, more than 50
/// million steps, or cancelled(). A year of 8 h days at one minute takes some 40 ms of processor time, on all
/// cores.
Result<SunSteps> computeSunSteps(const Period& period, const Observer& observer,
                                 const std::stop_token& stop = {});

/// The same; error where the sun is below the horizon at all steps.
Result<SunSteps> computeDaylightSteps(const Period& period, const Observer& observer, std::stop_token stop);

}  // namespace noonmark
