#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/sun/civil_time.h"
#include "core/sun/solar_position.h"

namespace noonmark::tests {

/// An instant in UTC.
inline Instant utc(int year, unsigned month, unsigned day, int hour = 0, int minute = 0, int second = 0) {
    using namespace std::chrono;
    const CivilDate date{std::chrono::year{year}, std::chrono::month{month}, std::chrono::day{day}};
    return sys_days{date} + hours{hour} + minutes{minute} + seconds{second};
}

inline Observer observerAt(double latDeg, double lonDeg) {
    Observer observer;
    observer.place = {lonDeg, latDeg};
    return observer;
}

/// Difference of two azimuths, degrees, also across north.
inline double azimuthDifference(Degrees a, Degrees b) {
    return std::abs(std::remainder(a.value - b.value, 360.0));
}

/// Angle on the sky between two directions, degrees.
inline double separation(Degrees azimuthA, Degrees altitudeA, Degrees azimuthB, Degrees altitudeB) {
    const glm::dvec3 a = toDirection(azimuthA, altitudeA);
    const glm::dvec3 b = toDirection(azimuthB, altitudeB);
    return Radians{2 * std::asin(std::min(1.0, glm::length(a - b) / 2))}.degrees().value;
}

inline double secondsBetween(Instant a, Instant b) {
    return std::abs(std::chrono::duration<double>(a - b).count());
}

}  // namespace noonmark::tests
