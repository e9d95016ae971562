#include "core/engines/graph/direction_bins.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/units.h"

namespace noonmark {

namespace {

// Shares of the bound for the two sides of a bin; the diagonal stays within the bound. The range of
// declinations in a year exceeds the range of hour angles at a given clock time, and columns must divide an
// hour evenly.
constexpr double columnShare = 0.6, ringShare = 0.42;
constexpr double degreesAMinute = 0.25;  // of hour angle

// Three directions of a day lie on a circle around the pole, passed clockwise as seen from the pole.
glm::dvec3 poleOf(const SunSteps& sun) {
    glm::dvec3 sum{};
    for (const SunDay& day : sun.days) {
        if (day.count < 3) continue;
        const auto at = [&](std::uint32_t step) { return glm::dvec3(sun.steps[day.first + step].direction); };
        const glm::dvec3 middle = at(day.count / 2);
        sum += glm::cross(at(day.count - 1) - middle, middle - at(0));
    }
    constexpr double noArc = 1e-9;  // directions have seven digits
    return glm::length(sum) < noArc ? glm::dvec3(0, 0, 1) : glm::normalize(sum);
}

// Where the meridian of noon crosses the celestial equator; arbitrary if the pole is the zenith.
glm::dvec3 noonOf(glm::dvec3 pole) {
    const glm::dvec3 up = glm::dvec3(0, 0, 1) - pole.z * pole;
    return glm::length(up) < 1e-6 ? glm::normalize(glm::cross(pole, glm::dvec3(1, 0, 0)))
                                  : glm::normalize(up);
}

int roundedDown(double value) { return int(std::floor(value)); }

}  // namespace

DirectionBins::DirectionBins(const SunSteps& sun, double boundDeg, double intervalMinutes)
    : pole_(poleOf(sun)),
      noon_(noonOf(pole_)),
      evening_(glm::cross(noon_, pole_)),
      ringDeg_(ringShare * boundDeg) {
    const double widest = columnShare * boundDeg;
    const double intervalDeg = intervalMinutes * degreesAMinute;
    const bool dividesWell = intervalDeg > widest / 2;
    columnDeg_ = dividesWell ? intervalDeg / std::ceil(intervalDeg / widest - 1e-9) : widest;
}

std::uint32_t DirectionBins::of(glm::dvec3 direction, double inMinutes) const {
    const double hourAngle =
        Radians{std::atan2(glm::dot(direction, evening_), glm::dot(direction, noon_))}.degrees().value +
        inMinutes * degreesAMinute;
    const double declination =
        Radians{std::asin(std::clamp(glm::dot(direction, pole_), -1.0, 1.0))}.degrees().value;
    // Bins are centred on noon and on the celestial equator, and numbered from the lowest hour angle and
    // declination.
    const int column = roundedDown((hourAngle + 180) / columnDeg_ + 0.5),
              ring = roundedDown((declination + 90) / ringDeg_ + 0.5);
    return std::uint32_t(ring) << 16U | std::uint32_t(column);
}

}  // namespace noonmark
