#pragma once

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

}  // namespace noonmark
