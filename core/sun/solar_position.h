#pragma once

#include <chrono>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "core/base/result.h"
#include "core/base/units.h"

namespace noonmark {

struct SunEvents;
enum class SunriseRule;

/// An instant in UTC. 1900 to 2100 is the range of the ephemeris (civil days of every zone of the earth at
/// both ends included).
using Instant = std::chrono::sys_time<std::chrono::milliseconds>;

/// Where on earth, and the air over it that bends the light. The defaults are the air that the formula of
/// refraction was made for, and the one that almanacs take. The observer of a city is made by observerIn
/// (core/city/city_observer.h), which knows how the place lies in the frame of the city's geometry.
struct Observer {
    LonLat place;
    double elevationM = 0;      ///< above the ellipsoid, -500 to 9000
    double pressureHPa = 1010;  ///< 0 to 1200
    double temperatureC = 10;   ///< -90 to 60
    /// How directions in east, north and up at the place read in the frame of the geometry. The identity
    /// where the place is that frame's origin. SunStep::direction is told in that frame; azimuths and
    /// altitudes stay those of the place.
    glm::dmat3 frameFromPlace{1.0};
    bool operator==(const Observer&) const = default;
};

/// The observer itself, or what is out of range.
Result<Observer> checked(const Observer& observer);

/// Centre of the sun's disc, topocentric.
struct SolarPosition {
    Degrees azimuth;   ///< from true north (of the earth's axis of date), clockwise, 0 <= azimuth < 360
    Degrees altitude;  ///< true (geometric, no refraction)
    Degrees altitudeApparent;  ///< with refraction; equals altitude where the sun is more than 1 deg below
                               ///< the horizon
};

/// One position from ERFA, not interpolated: within 0.0003 deg of NREL SPA and of JPL Horizons. About 30 us.
SolarPosition computeSolarPosition(const Observer& observer, Instant at);

/// Refraction to be added to a true altitude. Source of the formula: see the .cpp.
Degrees refraction(const Observer& observer, Degrees trueAltitude);

/// Unit vector towards the sun in the local frame: x east, y north, z up.
glm::dvec3 toDirection(Degrees azimuth, Degrees altitude);

/// Positions for many instants of a span: ERFA at a coarse spacing, interpolated; differs from solarPosition
/// by less than 0.00002 deg. A year of minutes costs milliseconds. Immutable once made; safe to share between
/// threads.
class Ephemeris {
public:
    /// Covers [from, to]; error outside 1900 to 2100, or for an observer out of range. 15 us for a day of the
    /// span.
    static Result<Ephemeris> over(const Observer& observer, Instant from, Instant to);
    ~Ephemeris();
    Ephemeris(Ephemeris&&) noexcept;
    Ephemeris& operator=(Ephemeris&&) noexcept;

    /// `at` within the span. About 100 ns.
    [[nodiscard]] SolarPosition at(Instant at) const;

    /// How far the sun is past the meridian at an instant within the span; west positive, -pi to pi.
    [[nodiscard]] Radians hourAngle(Instant at) const;

private:
    friend SunEvents computeSunEvents(const Observer& observer, Instant localMidnight, SunriseRule rule);
    static Ephemeris spanning(const Observer& observer, Instant from, Instant to);  // no check of the years

    Ephemeris();
    struct Table;
    std::shared_ptr<const Table> table_;
};

}  // namespace noonmark
