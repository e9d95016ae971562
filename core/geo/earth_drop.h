#pragma once

#include <glm/vec2.hpp>

namespace noonmark {

inline constexpr double meanEarthRadiusM = 6'371'009;  ///< IUGG
inline constexpr double rayBending = 0.13;  ///< Gauss's coefficient of refraction: of the earth's curvature

/// How far the earth's surface lies below the plane that touches it at the project's origin, as a horizontal
/// ray sees it, metres: d2 (1 - k) / 2R. R = 6,371,009 m, the mean radius (IUGG); k = 0.13, Gauss's
/// coefficient of refraction, by which rays near the ground bend with it: in keeping with suns that are taken
/// as seen. 7 cm at 1 km, 6.8 m at 10 km, 246 m at 60 km.
///
/// With it elevations are heights in that plane, as the sun's direction is, and the horizon of a distant
/// ridge comes out right for all engines. What it leaves out: k varies with the weather, by some 0.02 deg of
/// horizon at 30 km between none and twice as much.
inline double earthDropM(glm::dvec2 local) {
    return (local.x * local.x + local.y * local.y) * (1 - rayBending) / (2 * meanEarthRadiusM);
}

/// How steeply that drop falls at a point, metres per metre to the east and to the north: 0.008 deg for each
/// km from the origin.
inline glm::dvec2 earthDropSlope(glm::dvec2 local) { return local * ((1 - rayBending) / meanEarthRadiusM); }

}  // namespace noonmark
