#pragma once

#include <glm/vec3.hpp>

#include "core/sun/solar_position.h"

namespace noonmark {

/// UT1, the time scale of the earth's rotation: days since 2000-01-01 12:00.
///
/// UT1 - UTC is not predictable; leap seconds keep it under 0.9 s. It is taken as 0 up to 2024, as NREL SPA
/// does, and as 0.055 s from 2026 on, fitted to the JPL Horizons positions of that year in the tests; linear
/// in between. The remaining error, up to 0.9 s in years with many leap seconds, turns the sun by up to 0.004
/// deg.
double ut1Days(Instant at);

/// Terrestrial time, the time scale of the ephemeris: days since 2000-01-01 12:00. From 1972 on by leap
/// seconds; before, by the polynomials of Espenak and Meeus (NASA/TP-2006-214141) for TT - UT1.
double ttDays(Instant at);

/// Earth rotation angle (IAU 2000), 0 to 2 pi.
Radians earthRotation(double ut1Days);

/// East, north and up at an observer on the rotating earth. Accounts for the parallax of the place (0.0024
/// deg at most), diurnal aberration (0.0001 deg) and the mean position of the earth's axis (0.0001 deg; in
/// azimuth up to 0.0005 deg).
class ObserverFrame {
public:
    explicit ObserverFrame(const Observer& observer);

    /// Position of the sun whose geocentric vector is `apparentSun` (au, intermediate frame) at the earth
    /// rotation angle `rotation`.
    [[nodiscard]] SolarPosition position(const glm::dvec3& apparentSun, Radians rotation) const;

    /// Angle past the meridian, west positive, -pi to pi.
    [[nodiscard]] Radians hourAngle(const glm::dvec3& apparentSun, Radians rotation) const;

private:
    /// Axes: x outward in the plane of the meridian and parallel to the equator, y east, z along the earth's
    /// axis.
    [[nodiscard]] glm::dvec3 meridianFrame(const glm::dvec3& apparentSun, Radians rotation) const;

    Observer observer_;
    double longitudeRad_ = 0;
    double sinLatitude_ = 0;
    double cosLatitude_ = 1;
    double fromAxisAu_ = 0;     // distance of the place from the earth's axis
    double fromEquatorAu_ = 0;  // distance from the plane of the equator, north positive
    double aberrationAu_ = 0;   // shift of a sun at 1 au by the place's speed, towards the east
};

/// Vector from the earth's centre to the apparent sun (light time and aberration included), astronomical
/// units, in the celestial intermediate frame of date: z is the earth's axis, and the earth turns against x
/// by the earth rotation angle. The vector is smooth in time, so that an interpolation needs few values.
/// About 30 us; the ephemeris (VSOP2000, ERFA's epv00) is accurate to 0.00001 deg in 1900 to 2100.
glm::dvec3 computeApparentSun(double ttDays);

}  // namespace noonmark
