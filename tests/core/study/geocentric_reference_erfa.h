#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

/// Shadow computed directly on the rotating ellipsoid: positions and boxes in earth-centred coordinates, the
/// sun's position from ERFA, straight rays in double. Independent of the program: no frame, no sun, no
/// engine.
namespace noonmark::tests {

struct Geodetic {
    double lonDeg = 0;
    double latDeg = 0;
    double heightM = 0;  ///< above WGS84
};

/// Earth-centred, earth-fixed metres.
glm::dvec3 earthCentred(Geodetic place);

/// The place `eastM` and `northM` metres away along the ellipsoid; accurate to centimetres within a km.
Geodetic displaced(Geodetic place, double eastM, double northM);

/// The point of the ellipsoid, earth-centred, whose orthographic image on the tangent plane at `origin` is
/// `local`.
glm::dvec3 underOrthographic(Geodetic origin, glm::dvec2 local);

/// A block with vertical walls at its corners.
struct GeoBox {
    Geodetic corners[4];      ///< corners of its base, in order
    double heightsM[4] = {};  ///< height of its roof above each corner
};
GeoBox geoBox(Geodetic centre, double eastWidthM, double northWidthM, double heightM);

/// The sun, earth-centred, metres, at a UTC instant of 2017 to 2035.
glm::dvec3 sunPlace(double unixSeconds);

/// The direction towards the apparent sun from an earth-centred point, raised by refraction (Saemundsson,
/// 1010 hPa, 10 deg C) in the point's own vertical; and its altitude there.
struct SeenSun {
    glm::dvec3 towards;
    double altitudeDeg = 0;
};
SeenSun seenSun(glm::dvec3 from, glm::dvec3 sun);

struct GeoMinutes {
    double gross = 0;
    double longest = 0;
};

/// Minutes in shadow of a point on the ground over the steps of a day; each step counts as its first moment,
/// with the sun (sunPlace) at that time. Steps with the sun below the point's horizon are lit and end a run.
GeoMinutes minutesAt(glm::dvec3 ground, const std::vector<GeoBox>& boxes, const std::vector<glm::dvec3>& suns,
                     double stepMinutes);

}  // namespace noonmark::tests
