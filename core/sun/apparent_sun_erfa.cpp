#include "core/sun/apparent_sun.h"

#include <erfa.h>
#include <erfam.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr double secondsPerDay = 86400;
constexpr double ttMinusTaiS = 32.184;
constexpr double j2000 = 2451545.0;  // Julian date of 2000-01-01 12:00
constexpr auto epoch = sys_days{2000y / January / 1} + 12h;

double utcDays(Instant at) { return duration<double>(at - epoch).count() / secondsPerDay; }

double ut1MinusUtcS(double utcDaysSinceEpoch) {
    constexpr double measuredS = 0.055;
    constexpr double from = 24 * 365.25;  // 2024
    constexpr double to = 26 * 365.25;    // 2026
    return measuredS * std::clamp((utcDaysSinceEpoch - from) / (to - from), 0.0, 1.0);
}

/// TT - UT1 in seconds before leap seconds were introduced; Espenak and Meeus, for 1900 to 1986.
double ttMinusUt1S(double year) {
    if (year < 1920) {
        const double t = year - 1900;
        return -2.79 + t * (1.494119 + t * (-0.0598939 + t * (0.0061966 - t * 0.000197)));
    }
    if (year < 1941) {
        const double t = year - 1920;
        return 21.20 + t * (0.84493 + t * (-0.076100 + t * 0.0020936));
    }
    const double t = year - (year < 1961 ? 1950 : 1975);
    return year < 1961 ? 29.07 + t * (0.407 + t * (-1 / 233.0 + t / 2547))
                       : 45.45 + t * (1.067 + t * (-1 / 260.0 - t / 718));
}

double taiMinusUtcS(Instant at) {
    const year_month_day date{floor<days>(at)};
    double seconds = 0;
    eraDat(int(date.year()), int(unsigned(date.month())), int(unsigned(date.day())), 0, &seconds);
    return seconds;
}

}  // namespace

double ut1Days(Instant at) {
    const double utc = utcDays(at);
    return utc + ut1MinusUtcS(utc) / secondsPerDay;
}

double ttDays(Instant at) {
    const double utc = utcDays(at);
    const bool leapSeconds = at >= sys_days{1972y / January / 1};
    const double offsetS = leapSeconds ? ttMinusTaiS + taiMinusUtcS(at) : ttMinusUt1S(2000 + utc / 365.25);
    return utc + offsetS / secondsPerDay;
}

Radians earthRotation(double ut1Days) { return {eraEra00(j2000, ut1Days)}; }

namespace {

constexpr double metresPerAu = 149597870700.0;
constexpr double earthTurnRadPerS = 7.292115e-5;
constexpr double lightMPerS = 299792458.0;

// Secular pole of the IERS Conventions (2010, update of 2018) at 2000.0. Chandler's wobble and the drift of
// the pole stay within 0.3 arc seconds of it.
constexpr double poleX = 0.0550 * ERFA_DAS2R;
constexpr double poleY = 0.3205 * ERFA_DAS2R;

/// Longitude and latitude about the axis of date instead of the map's pole; almanacs and JPL Horizons define
/// azimuth this way. Beyond 80 deg that north diverges from the map's (at the pole by any angle), so the
/// difference is held at its value at 80 deg.
struct PlaceOfDate {
    double longitudeRad;
    double latitudeRad;
};

PlaceOfDate placeOfDate(LonLat place) {
    const double lon = Degrees{place.lonDeg}.radians().value;
    const double lat = Degrees{place.latDeg}.radians().value;
    const double bounded = std::clamp(lat, -80 * ERFA_DD2R, 80 * ERFA_DD2R);
    return {lon + (poleX * std::sin(lon) + poleY * std::cos(lon)) * std::tan(bounded),
            lat + poleX * std::cos(lon) - poleY * std::sin(lon)};
}

Degrees computeAzimuth(const glm::dvec3& eastNorthUp) {
    const double azimuth = Radians{std::atan2(eastNorthUp.x, eastNorthUp.y)}.degrees().value;
    const double turned = azimuth < 0 ? azimuth + 360 : azimuth;
    return {turned < 360 ? turned : 0};  // a tiny negative angle rounds to 360
}

Degrees altitudeOf(const glm::dvec3& eastNorthUp) {
    const double level = std::sqrt(eastNorthUp.x * eastNorthUp.x + eastNorthUp.y * eastNorthUp.y);
    return Radians{std::atan2(eastNorthUp.z, level)}.degrees();
}

}  // namespace

ObserverFrame::ObserverFrame(const Observer& observer) : observer_(observer) {
    double metres[3] = {};
    eraGd2gc(ERFA_WGS84, 0, Degrees{observer.place.latDeg}.radians().value, observer.elevationM, metres);
    fromAxisAu_ = metres[0] / metresPerAu;
    fromEquatorAu_ = metres[2] / metresPerAu;
    aberrationAu_ = metres[0] * earthTurnRadPerS / lightMPerS;
    const PlaceOfDate place = placeOfDate(observer.place);
    longitudeRad_ = place.longitudeRad;
    sinLatitude_ = std::sin(place.latitudeRad);
    cosLatitude_ = std::cos(place.latitudeRad);
}

glm::dvec3 ObserverFrame::meridianFrame(const glm::dvec3& sun, Radians rotation) const {
    const double angle = rotation.value + longitudeRad_;
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    return {cosine * sun.x + sine * sun.y - fromAxisAu_, cosine * sun.y - sine * sun.x + aberrationAu_,
            sun.z - fromEquatorAu_};
}

Radians ObserverFrame::hourAngle(const glm::dvec3& apparentSun, Radians rotation) const {
    const glm::dvec3 sun = meridianFrame(apparentSun, rotation);
    return {std::atan2(-sun.y, sun.x)};
}

SolarPosition ObserverFrame::position(const glm::dvec3& apparentSun, Radians rotation) const {
    const glm::dvec3 sun = meridianFrame(apparentSun, rotation);
    const glm::dvec3 local{sun.y, cosLatitude_ * sun.z - sinLatitude_ * sun.x,
                           cosLatitude_ * sun.x + sinLatitude_ * sun.z};
    const Degrees altitude = altitudeOf(local);
    return {computeAzimuth(local), altitude, {altitude.value + refraction(observer_, altitude).value}};
}

namespace {
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
