#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// Divides the sky into cells between circles of declination and of hour angle. In these coordinates the sun
/// moves uniformly: along one of them during a day, along the other during a year. Both ends of an hour
/// therefore leave their bins on the same days of the year, and fewer pairs of bins occur than with azimuth
/// and altitude. Two directions of a bin are less than `boundDeg` apart.
class DirectionBins {
public:
    /// `intervalMinutes`: from the start of an interval to the start of the next; a multiple of the columns'
    /// width. The pole is derived from the steps' arcs; without arcs, bins are of azimuth and altitude.
    DirectionBins(const SunSteps& sun, double boundDeg, double intervalMinutes);

    /// Number of the bin in which the sun, now in `direction` (a unit vector), will be in `inMinutes`
    /// minutes.
    [[nodiscard]] std::uint32_t of(glm::dvec3 direction, double inMinutes = 0) const;

private:
    glm::dvec3 pole_{0, 0, 1}, noon_{0, -1, 0}, evening_{-1, 0, 0};  // orthogonal unit vectors
    double columnDeg_ = 1, ringDeg_ = 1;
};

}  // namespace noonmark
