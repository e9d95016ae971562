#pragma once

#include <glm/vec3.hpp>

namespace noonmark {

/// From the earth's centre to the sun as it appears there (light time, aberration), astronomical units, in
/// the celestial intermediate frame of date: z the earth's axis, and the earth turns against x by the earth
/// rotation angle. Smooth in time, so that few values carry an interpolation. About 30 us; the ephemeris
/// (VSOP2000, ERFA's epv00) is good to 0.00001 deg in 1900 to 2100.
glm::dvec3 computeApparentSun(double ttDays);

}  // namespace noonmark
