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

/// The sun over a period: the only thing that engines know of time. Steps in time order; step k of a day
/// stands for the half-open interval [from + k step, from + (k + 1) step). A day with hours = 0 has one step
/// of `stepMinutes` = 1.
struct SunSteps {
    double stepMinutes = 1;
    std::vector<SunStep> steps;
    std::vector<SunDay> days;  ///< all days of the period, in order
    std::size_t belowHorizon = 0;
    /// Of the steps of the period as it was asked for: above the observer's horizon, but below the plane of
    /// the geometry's frame, which the drop of the terrain tilts against it far from the origin. Taken in
    /// that plane.
    std::size_t levelled = 0;

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
Result<SunSteps> sunSteps(const Period& period, const Observer& observer, const std::stop_token& stop = {});

}  // namespace noonmark
