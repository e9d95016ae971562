#pragma once

#include <glm/vec3.hpp>

#include "core/sun/solar_position.h"

namespace noonmark {

/// East, north and up at an observer on the rotating earth. Accounts for the parallax of the place (0.0024
/// deg at most), diurnal aberration (0.0001 deg) and the mean position of the earth's axis (0.0001 deg; in
/// azimuth up to 0.0005 deg).
class ObserverFrame {
public:
    explicit ObserverFrame(const Observer& observer);

    /// Position of the sun whose geocentric vector is `apparentSun` (au, intermediate frame) at the earth
    /// rotation angle `rotation`.
    [[nodiscard]] SolarPosition position(const glm::dvec3& apparentSun, Radians rotation) const;

    /// Angle past the meridian, west positive, -pi to pi.
    [[nodiscard]] Radians hourAngle(const glm::dvec3& apparentSun, Radians rotation) const;

private:
    /// Axes: x outward in the plane of the meridian and parallel to the equator, y east, z along the earth's
    /// axis.
    [[nodiscard]] glm::dvec3 meridianFrame(const glm::dvec3& apparentSun, Radians rotation) const;

    Observer observer_;
    double longitudeRad_ = 0;
    double sinLatitude_ = 0;
    double cosLatitude_ = 1;
    double fromAxisAu_ = 0;     // distance of the place from the earth's axis
    double fromEquatorAu_ = 0;  // distance from the plane of the equator, north positive
    double aberrationAu_ = 0;   // shift of a sun at 1 au by the place's speed, towards the east
};

}  // namespace noonmark
