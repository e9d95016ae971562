#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// Cells of the sky between circles of declination and of hour angle, the coordinates in which the sun moves
/// evenly: along one of them within a day, along the other within a year. Both ends of an hour then leave
/// their bins on the same days of the year, so that fewer pairs of bins are met than with azimuth and
/// altitude. Two directions of a bin are less than `boundDeg` apart.
class DirectionBins {
public:
    /// `intervalMinutes`: from an interval's begin to the next one's; columns divide it evenly. The pole
    /// comes from the steps' own arcs; where there are none, bins are of azimuth and altitude.
    DirectionBins(const SunSteps& sun, double boundDeg, double intervalMinutes);

    /// Number of the bin to which the sun, seen in `direction` (a unit vector), comes in so many minutes.
    [[nodiscard]] std::uint32_t of(glm::dvec3 direction, double inMinutes = 0) const;

private:
    glm::dvec3 pole_{0, 0, 1}, noon_{0, -1, 0}, evening_{-1, 0, 0};  // at right angles
    double columnDeg_ = 1, ringDeg_ = 1;
};

}  // namespace noonmark
