#pragma once

#include "core/city/city.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// Who sees the sun at `local` (metres in the city's frame), in the usual air. Whatever takes the sun to a
/// city's geometry begins here: the frame of the geometry has its north and its vertical at the frame's
/// origin, and away from it these are not the observer's own.
///
/// frameFromPlace is the differential, at the observer, of the map from the ground to the city's geometry:
/// - east and north by Frame::localFromEastNorth (north turns by the convergence: 0.46 deg at 27 km east of
///   the origin in 62 deg of latitude);
/// - flat ground: up stays up, since heights are heights above the ground everywhere;
/// - terrain: elevations were lowered by earthDropM, a paraboloid about the origin. About the observer it is
///   the same paraboloid and a slope (earthDropSlope), which the sun gets too.
///
/// What is left elsewhere in a region, where the vertical is not the observer's: see verticalErrorDeg.
Observer placeObserver(const City& city, glm::dvec2 local);

/// How far the direction of this observer's sun may be off at a place so far away, degrees: the angle between
/// the two verticals, 0.009 deg (2 s of the sun's way) a km. On terrain, whose drop holds most of that angle,
/// by about an eighth of it while the sun is low.
double computeVerticalErrorDeg(double distanceM);

}  // namespace noonmark
