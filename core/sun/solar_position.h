#pragma once

#include <chrono>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/describe/codec.h"

namespace noonmark {

struct SunEvents;
enum class SunriseRule;

/// An instant in UTC. The ephemeris covers 1900 to 2100 (including the civil days of every time zone at both
/// ends).
using Instant = std::chrono::sys_time<std::chrono::milliseconds>;

/// A place on earth and the state of its air, which determines refraction. The default air is the one that
/// the refraction formula was made for and that almanacs use. placeObserver() (core/city/city_position.h)
/// makes the observer of a city; it knows how the place lies in the frame of the city's geometry.
struct Observer {
    LonLat place;
    double elevationM = 0;  ///< above the ellipsoid, -500 to 9000
    static constexpr ValueRange pressureRangeHPa{0, 1200};
    static constexpr ValueRange temperatureRangeC{-90, 60};
    double pressureHPa = 1010;
    double temperatureC = 10;
    /// Transforms directions from east, north and up at the place to the frame of the geometry. The identity
    /// if the place is that frame's origin. SunStep::direction is in the frame of the geometry; azimuths and
    /// altitudes remain those of the place.
    glm::dmat3 frameFromPlace{1.0};
    bool operator==(const Observer&) const = default;
};

/// The observer itself, or an error that names the value out of range.
Result<Observer> validate(const Observer& observer);

/// Centre of the sun's disc, topocentric.
struct SolarPosition {
    Degrees azimuth;   ///< from true north (of the earth's axis of date), clockwise, 0 <= azimuth < 360
    Degrees altitude;  ///< true (geometric, no refraction)
    Degrees altitudeApparent;  ///< with refraction; equals altitude where the sun is more than 1 deg below
                               ///< the horizon
};

/// One position from ERFA, not interpolated: within 0.0003 deg of NREL SPA and of JPL Horizons. About 30 us.
SolarPosition computeSolarPosition(const Observer& observer, Instant at);

/// Refraction to add to a true altitude. Source of the formula: see the .cpp.
Degrees refraction(const Observer& observer, Degrees trueAltitude);

/// Density of the air by that of the default air, which refraction is proportional to; 1 for the default, 0
/// without air.
double relativeAirDensity(const Observer& observer);

/// Unit vector towards the sun in the local frame: x east, y north, z up.
glm::dvec3 toDirection(Degrees azimuth, Degrees altitude);

/// Positions for many instants of a span: ERFA at a coarse spacing, interpolated; differs from
/// computeSolarPosition by less than 0.00002 deg. A year of minutes costs milliseconds. Immutable once made;
/// safe to share between threads.
class Ephemeris {
public:
    /// Covers [from, to]; Error outside 1900 to 2100, or for an observer out of range. 15 us for each day of
    /// the span.
    static Result<Ephemeris> over(const Observer& observer, Instant from, Instant to);
    ~Ephemeris();
    Ephemeris(Ephemeris&&) noexcept;
    Ephemeris& operator=(Ephemeris&&) noexcept;

    /// `at` within the span. About 100 ns.
    [[nodiscard]] SolarPosition at(Instant at) const;

    /// Hour angle at an instant within the span: the sun's angle past the meridian, west positive, -pi to pi.
    [[nodiscard]] Radians hourAngle(Instant at) const;

    [[nodiscard]] double airDensity() const;  ///< relativeAirDensity() of its observer

private:
    friend SunEvents computeSunEvents(const Observer& observer, Instant localMidnight, SunriseRule rule,
                                      Degrees horizonDip);
    // does not check the years
    static Ephemeris spanning(const Observer& observer, Instant from, Instant to);

    Ephemeris();
    struct Table;
    std::shared_ptr<const Table> table_;
};

}  // namespace noonmark
