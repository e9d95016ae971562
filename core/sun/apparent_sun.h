#pragma once

#include <glm/vec3.hpp>

namespace noonmark {

/// Vector from the earth's centre to the apparent sun (light time and aberration included), astronomical
/// units, in the celestial intermediate frame of date: z is the earth's axis, and the earth turns against x
/// by the earth rotation angle. The vector is smooth in time, so that an interpolation needs few values.
/// About 30 us; the ephemeris (VSOP2000, ERFA's epv00) is accurate to 0.00001 deg in 1900 to 2100.
glm::dvec3 computeApparentSun(double ttDays);

}  // namespace noonmark
