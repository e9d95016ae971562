#pragma once

#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "core/geo/frame.h"

namespace noonmark {

/// The azimuth that a surface faces, from true north, clockwise, 0 to 360 degrees; NaN for a level surface.
/// `normal`: in the local frame.
inline double facingAzimuthDeg(const Frame& frame, LonLat place, glm::vec3 normal) {
    const glm::dvec2 level(normal);
    if (std::hypot(level.x, level.y) < 1e-3) return std::nan("");
    const glm::dvec2 eastNorth = glm::inverse(frame.localFromEastNorth(place)) * level;
    const double azimuth = Radians{std::atan2(eastNorth.x, eastNorth.y)}.degrees().value;
    return azimuth < 0 ? azimuth + 360 : azimuth;
}

}  // namespace noonmark
