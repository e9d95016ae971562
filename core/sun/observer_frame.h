#pragma once

#include <glm/vec3.hpp>

#include "core/sun/solar_position.h"

namespace noonmark {

/// East, north and up at an observer on the turning earth. Knows the parallax of the place (0.0024 deg at
/// most), the aberration by the earth's turning (0.0001 deg) and the mean place of the earth's axis (0.0001
/// deg; in azimuth up to 0.0005 deg).
class ObserverFrame {
public:
    explicit ObserverFrame(const Observer& observer);

    /// Where the sun stands whose geocentric vector is `apparentSun` (au, intermediate frame), the earth
    /// being turned by `rotation`.
    [[nodiscard]] SolarPosition position(const glm::dvec3& apparentSun, Radians rotation) const;

    /// Angle past the meridian, west positive, -pi to pi.
    [[nodiscard]] Radians hourAngle(const glm::dvec3& apparentSun, Radians rotation) const;

private:
    /// x outward in the meridian and the plane of the equator, y east, z along the earth's axis.
    [[nodiscard]] glm::dvec3 meridianFrame(const glm::dvec3& apparentSun, Radians rotation) const;

    Observer observer_;
    double longitudeRad_ = 0;
    double sinLatitude_ = 0;
    double cosLatitude_ = 1;
    double fromAxisAu_ = 0;     // distance of the place from the earth's axis
    double fromEquatorAu_ = 0;  // and from the plane of the equator, north positive
    double aberrationAu_ = 0;   // what the place's speed moves a sun at 1 au, to the east
};

}  // namespace noonmark
