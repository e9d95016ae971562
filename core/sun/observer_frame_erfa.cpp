#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/sun/observer_frame.h"

namespace noonmark {

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

Degrees azimuthOf(const glm::dvec3& eastNorthUp) {
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
    return {azimuthOf(local), altitude, {altitude.value + refraction(observer_, altitude).value}};
}

}  // namespace noonmark
