#pragma once

#include <chrono>
#include <glm/vec3.hpp>
#include <memory>

#include "core/result.h"
#include "core/units.h"

namespace noonmark {

/// An instant in UTC. 1900 to 2100 is the range of the ephemeris.
using Instant = std::chrono::sys_time<std::chrono::milliseconds>;

/// Where on earth, and the air over it that bends the light.
struct Observer {
    LonLat place;
    double elevationM = 0;       ///< above the ellipsoid, -500 to 9000
    double pressureHPa = 1013.25;  ///< 0 to 1200
    double temperatureC = 15;    ///< -90 to 60
};

/// Centre of the sun's disc, topocentric.
struct SolarPosition {
    Degrees azimuth;           ///< from true north, clockwise, 0 <= azimuth < 360
    Degrees altitude;          ///< true (geometric, no refraction)
    Degrees altitudeApparent;  ///< with refraction; equals altitude where the sun is more than 1 deg below the horizon
};

/// One position from ERFA, not interpolated: within 0.0003 deg of NREL SPA. About 30 us.
SolarPosition solarPosition(const Observer& observer, Instant at);

/// Refraction to be added to a true altitude. Source of the formula: see the .cpp.
Degrees refraction(const Observer& observer, Degrees trueAltitude);

/// Unit vector towards the sun in the local frame: x east, y north, z up.
glm::dvec3 directionFromAzimuthAltitude(Degrees azimuth, Degrees altitude);

/// Positions for many instants of a span: ERFA at a coarse spacing, interpolated; differs from solarPosition by less than
/// 0.00002 deg. A year of minutes costs milliseconds. Immutable once made; safe to share between threads.
class Ephemeris {
public:
    /// Covers [from, to]; error outside 1900 to 2100.
    static Result<Ephemeris> over(const Observer& observer, Instant from, Instant to);
    ~Ephemeris();
    Ephemeris(Ephemeris&&) noexcept;
    Ephemeris& operator=(Ephemeris&&) noexcept;

    /// `at` within the span. About 50 ns.
    [[nodiscard]] SolarPosition at(Instant at) const;

private:
    Ephemeris();
    struct Table;
    std::shared_ptr<const Table> table_;
};

}  // namespace noonmark
