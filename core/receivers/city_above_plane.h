#pragma once

#include <optional>

#include "core/city/city.h"

namespace noonmark {

/// What of a city stands above a horizontal plane, lowered by its height, so that the plane becomes level
/// ground, on which the exact engines work. `planeM`: metres above the ground, at least 0. Buildings wholly
/// below the plane are left out. Nothing where the city has terrain or a mesh: there, receivers must be
/// raised instead (raiseToPlane()).
std::optional<City> cutAbovePlane(const City& city, double planeM);

}  // namespace noonmark
