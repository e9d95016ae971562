#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

/// Shadow worked out on the turning ellipsoid itself: places and boxes in earth-centred coordinates, the sun
/// as a place from ERFA, straight rays in double. Shares no code with the program: no frame, no sun, no
/// engine.
namespace noonmark::tests {

struct Geodetic {
    double lonDeg = 0;
    double latDeg = 0;
    double heightM = 0;  ///< above WGS84
};

/// Earth-centred, earth-fixed metres.
glm::dvec3 earthCentred(Geodetic place);

/// So many metres to the east and north along the ellipsoid; exact to centimetres within a km.
Geodetic displaced(Geodetic place, double eastM, double northM);

/// The place of the ellipsoid whose orthographic image on the plane that touches it at `origin` is `local`,
/// earth-centred.
glm::dvec3 underOrthographic(Geodetic origin, glm::dvec2 local);

/// A block with walls along the verticals of its corners.
struct GeoBox {
    Geodetic corners[4];      ///< of its base, in order
    double heightsM[4] = {};  ///< of its roof above each
};
GeoBox geoBox(Geodetic centre, double eastWidthM, double northWidthM, double heightM);

/// The sun, earth-centred, metres, at a UTC instant of 2017 to 2035.
glm::dvec3 sunPlace(double unixSeconds);

/// Towards the sun as it appears from an earth-centred point: lifted by refraction (Saemundsson, 1010 hPa,
/// 10 deg C) in the point's own vertical. And how high it stands there.
struct SeenSun {
    glm::dvec3 towards;
    double altitudeDeg = 0;
};
SeenSun seenSun(glm::dvec3 from, glm::dvec3 sun);

struct GeoMinutes {
    double gross = 0;
    double longest = 0;
};

/// Minutes in shadow of a point of the ground over the steps of a day, each as its first moment is, with the
/// sun (sunPlace) there; steps with the sun below the point's horizon are lit and end a run.
GeoMinutes minutesAt(glm::dvec3 ground, const std::vector<GeoBox>& boxes, const std::vector<glm::dvec3>& suns,
                     double stepMinutes);

}  // namespace noonmark::tests
