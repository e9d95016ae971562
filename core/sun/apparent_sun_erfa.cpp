#include "core/sun/apparent_sun.h"

#include <erfa.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

constexpr double j2000 = 2451545.0;
constexpr double lightDaysPerAu = 499.004783836 / 86400;

glm::dvec3 vectorOf(const double v[3]) { return {v[0], v[1], v[2]}; }

struct EarthAndSun {
    glm::dvec3 sunFromEarth;   // au, at the same instant
    glm::dvec3 sunVelocity;    // au per day, barycentric
    glm::dvec3 earthVelocity;  // au per day, barycentric
};

EarthAndSun earthAndSun(double ttDays) {
    double heliocentric[2][3];
    double barycentric[2][3];
    eraEpv00(j2000, ttDays, heliocentric, barycentric);
    return {-vectorOf(heliocentric[0]), vectorOf(barycentric[1]) - vectorOf(heliocentric[1]),
            vectorOf(barycentric[1])};
}

/// Applies light time (the sun is seen where it was) and aberration (the earth's speed tilts the light).
glm::dvec3 asSeen(const EarthAndSun& at) {
    const double distance = glm::length(at.sunFromEarth);
    const glm::dvec3 past = at.sunFromEarth - at.sunVelocity * (distance * lightDaysPerAu);
    glm::dvec3 natural = past / distance;
    glm::dvec3 speed = at.earthVelocity * lightDaysPerAu;
    glm::dvec3 proper{};
    eraAb(&natural.x, &speed.x, distance, std::sqrt(1 - glm::dot(speed, speed)), &proper.x);
    return proper * distance;
}

}  // namespace

glm::dvec3 computeApparentSun(double ttDays) {
    double precessionNutation[3][3];
    double x = 0;
    double y = 0;
    double toIntermediate[3][3];
    // The abridged nutation model: accurate to 0.001 arc seconds
    eraPnm00b(j2000, ttDays, precessionNutation);
    eraBpn2xy(precessionNutation, &x, &y);
    eraC2ixys(x, y, eraS00(j2000, ttDays, x, y), toIntermediate);
    glm::dvec3 seen = asSeen(earthAndSun(ttDays));
    glm::dvec3 intermediate{};
    eraRxp(toIntermediate, &seen.x, &intermediate.x);
    return intermediate;
}

}  // namespace noonmark
