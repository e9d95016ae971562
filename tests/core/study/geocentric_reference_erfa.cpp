#include "tests/core/study/geocentric_reference_erfa.h"

#include <erfa.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace noonmark::tests {

namespace {

constexpr double equatorM = 6378137, flattening = 1 / 298.257223563;
constexpr double squaredEccentricity = flattening * (2 - flattening);
constexpr double poleM = equatorM * (1 - flattening);
constexpr double degree = std::numbers::pi / 180;
constexpr double metresAnAu = 149597870700.0;

glm::dvec3 upAt(double lonDeg, double latDeg) {
    const double lon = lonDeg * degree, lat = latDeg * degree;
    return {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
}

// The vertical at a point of the ellipsoid: the gradient of its equation.
glm::dvec3 upAt(glm::dvec3 ground) {
    return glm::normalize(ground / glm::dvec3(equatorM * equatorM, equatorM * equatorM, poleM * poleM));
}

double crossRadius(double latDeg) {
    const double sine = std::sin(latDeg * degree);
    return equatorM / std::sqrt(1 - squaredEccentricity * sine * sine);
}

struct Triangle {
    glm::dvec3 a, b, c;
};

// Intersection of a ray and a triangle by Moeller and Trumbore.
bool meets(glm::dvec3 from, glm::dvec3 towards, const Triangle& triangle) {
    const glm::dvec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const glm::dvec3 p = glm::cross(towards, ac);
    const double scale = glm::dot(ab, p);
    if (scale == 0) return false;
    const glm::dvec3 t = from - triangle.a;
    const double u = glm::dot(t, p) / scale;
    const glm::dvec3 q = glm::cross(t, ab);
    const double v = glm::dot(towards, q) / scale;
    return u >= 0 && v >= 0 && u + v <= 1 && glm::dot(ac, q) / scale > 0;
}

// Walls only: from outside, every line of sight through a box passes through a wall.
std::vector<Triangle> wallsOf(const std::vector<GeoBox>& boxes, glm::dvec3 from) {
    std::vector<Triangle> walls;
    for (const GeoBox& box : boxes)
        for (int i = 0; i < 4; ++i) {
            Geodetic first = box.corners[i], second = box.corners[(i + 1) % 4];
            const glm::dvec3 a = earthCentred(first) - from, b = earthCentred(second) - from;
            first.heightM += box.heightsM[i], second.heightM += box.heightsM[(i + 1) % 4];
            const glm::dvec3 c = earthCentred(second) - from, d = earthCentred(first) - from;
            walls.push_back({a, b, c});
            walls.push_back({a, c, d});
        }
    return walls;
}

double refractionDeg(double altitudeDeg) {
    return 1.02 / std::tan((altitudeDeg + 10.3 / (altitudeDeg + 5.11)) * degree) / 60;
}

}  // namespace

glm::dvec3 earthCentred(Geodetic place) {
    const double radius = crossRadius(place.latDeg);
    const glm::dvec3 up = upAt(place.lonDeg, place.latDeg);
    return {(radius + place.heightM) * up.x, (radius + place.heightM) * up.y,
            (radius * (1 - squaredEccentricity) + place.heightM) * up.z};
}

Geodetic displaced(Geodetic place, double eastM, double northM) {
    const double cross = crossRadius(place.latDeg);
    const double along = cross * cross * cross * (1 - squaredEccentricity) / (equatorM * equatorM);
    place.latDeg += northM / along / degree;
    place.lonDeg += eastM / (crossRadius(place.latDeg) * std::cos(place.latDeg * degree)) / degree;
    if (place.lonDeg > 180) place.lonDeg -= 360;
    if (place.lonDeg < -180) place.lonDeg += 360;
    return place;
}

glm::dvec3 underOrthographic(Geodetic origin, glm::dvec2 local) {
    const double lon = origin.lonDeg * degree, lat = origin.latDeg * degree;
    const glm::dvec3 east(-std::sin(lon), std::cos(lon), 0);
    const glm::dvec3 north(-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat));
    const glm::dvec3 up = upAt(origin.lonDeg, origin.latDeg);
    const glm::dvec3 inPlane = earthCentred(origin) + local.x * east + local.y * north;
    // (x / a)^2 + (y / a)^2 + (z / b)^2 = 1 along the vertical of the origin: the root nearer to the plane.
    const glm::dvec3 axes(equatorM, equatorM, poleM);
    const glm::dvec3 p = inPlane / axes, d = up / axes;
    const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - 1;
    return inPlane + up * (-c / (b + std::sqrt(b * b - a * c)));
}

GeoBox geoBox(Geodetic centre, double eastWidthM, double northWidthM, double heightM) {
    const double east = eastWidthM / 2, north = northWidthM / 2;
    return {{displaced(centre, -east, -north), displaced(centre, east, -north),
             displaced(centre, east, north), displaced(centre, -east, north)},
            {heightM, heightM, heightM, heightM}};
}

glm::dvec3 sunPlace(double unixSeconds) {
    constexpr double unixEpoch = 2440587.5, ttLessUtcS = 37 + 32.184, ut1LessUtcS = 0.05;
    const double day = unixSeconds / 86400;
    const double tt = day + ttLessUtcS / 86400, ut1 = day + ut1LessUtcS / 86400;
    double heliocentric[2][3], barycentric[2][3];
    eraEpv00(unixEpoch, tt, heliocentric, barycentric);
    const double au = std::hypot(heliocentric[0][0], heliocentric[0][1], heliocentric[0][2]);
    constexpr double lightAuADay = 173.1446326846693;
    double towards[3], velocity[3], seen[3];
    double speed2 = 0;
    for (int i = 0; i < 3; ++i) {
        towards[i] = -heliocentric[0][i] / au;
        velocity[i] = barycentric[1][i] / lightAuADay;
        speed2 += velocity[i] * velocity[i];
    }
    eraAb(towards, velocity, au, std::sqrt(1 - speed2), seen);
    double celestialToEarth[3][3], fixed[3];
    eraC2t06a(unixEpoch, tt, unixEpoch, ut1, 0, 0, celestialToEarth);
    eraRxp(celestialToEarth, seen, fixed);
    return glm::dvec3(fixed[0], fixed[1], fixed[2]) * (au * metresAnAu);
}

SeenSun seenSun(glm::dvec3 from, glm::dvec3 sun) {
    const glm::dvec3 up = upAt(from), straight = glm::normalize(sun - from);
    const double trueDeg = std::asin(glm::dot(straight, up)) / degree;
    const double seenDeg = trueDeg + (trueDeg > -1 ? refractionDeg(trueDeg) : 0);
    const glm::dvec3 level = glm::normalize(straight - up * glm::dot(straight, up));
    return {std::cos(seenDeg * degree) * level + std::sin(seenDeg * degree) * up, seenDeg};
}

GeoMinutes minutesAt(glm::dvec3 ground, const std::vector<GeoBox>& boxes, const std::vector<glm::dvec3>& suns,
                     double stepMinutes) {
    const std::vector<Triangle> walls = wallsOf(boxes, ground);
    const glm::dvec3 eye = upAt(ground) * 1e-3;
    GeoMinutes minutes;
    double run = 0;
    for (const glm::dvec3 place : suns) {
        const SeenSun sun = seenSun(ground, place);
        const bool shaded = sun.altitudeDeg > 0 && std::ranges::any_of(walls, [&](const Triangle& wall) {
                                return meets(eye, sun.towards, wall);
                            });
        run = shaded ? run + stepMinutes : 0;
        minutes.gross += shaded ? stepMinutes : 0;
        minutes.longest = std::max(minutes.longest, run);
    }
    return minutes;
}

}  // namespace noonmark::tests
