#pragma once

#include <glm/vec2.hpp>

namespace noonmark {

inline constexpr double meanEarthRadiusM = 6'371'009;  ///< IUGG
/// Gauss's coefficient of refraction, as a share of the earth's curvature
inline constexpr double rayBending = 0.13;

/// How far the earth's surface lies below the tangent plane at the project's origin, as a horizontal ray sees
/// it, metres: d2 (1 - k) / 2R. R = 6,371,009 m, the mean radius (IUGG); k = 0.13, Gauss's coefficient of
/// refraction: rays near the ground bend with the earth's surface. This is consistent with sun positions that
/// include refraction. 7 cm at 1 km, 6.8 m at 10 km, 246 m at 60 km.
///
/// Lowering elevations by this drop turns them into heights above that plane, the plane that the sun's
/// direction refers to, so that all engines get the horizon of a distant ridge right. Neglected: k varies
/// with the weather; between k = 0 and twice the value used here, a horizon at 30 km moves by some 0.02 deg.
inline double earthDropM(glm::dvec2 local) {
    return (local.x * local.x + local.y * local.y) * (1 - rayBending) / (2 * meanEarthRadiusM);
}

/// Slope of that drop at a point, metres per metre towards the east and the north: 0.008 deg for each km from
/// the origin.
inline glm::dvec2 earthDropSlope(glm::dvec2 local) { return local * ((1 - rayBending) / meanEarthRadiusM); }

}  // namespace noonmark
