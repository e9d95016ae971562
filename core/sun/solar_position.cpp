#include "core/sun/solar_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/sun/apparent_sun.h"
#include "core/sun/observer_frame.h"
#include "core/sun/time_scales.h"

namespace noonmark {

namespace {

struct Field {
    const char* name;
    double value;
    double lowest;
    double highest;
    const char* unit;
};

bool inRange(const Field& field) { return field.value >= field.lowest && field.value <= field.highest; }

}  // namespace

Result<Observer> validate(const Observer& observer) {
    const Field fields[] = {{"longitude", observer.place.lonDeg, -180, 180, "degrees"},
                            {"latitude", observer.place.latDeg, -90, 90, "degrees"},
                            {"elevation", observer.elevationM, -500, 9000, "m"},
                            {"pressure", observer.pressureHPa, 0, 1200, "hPa"},
                            {"temperature", observer.temperatureC, -90, 60, "deg C"}};
    for (const Field& field : fields) {
        if (inRange(field)) continue;
        return failure(fmt::format("{:g} {} is out of range", field.value, field.unit), field.name,
                       fmt::format("Give {:g} to {:g}", field.lowest, field.highest));
    }
    return observer;
}

SolarPosition computeSolarPosition(const Observer& observer, Instant at) {
    return ObserverFrame(observer).position(computeApparentSun(ttDays(at)), earthRotation(ut1Days(at)));
}

double relativeAirDensity(const Observer& observer) {
    return observer.pressureHPa / 1010 * 283 / (273 + observer.temperatureC);
}

Degrees refraction(const Observer& observer, Degrees trueAltitude) {
    // Saemundsson (Sky and Telescope 72, 1986, p. 70), made for 1010 hPa and 10 deg C, scaled by the density
    // of the air as in Meeus, Astronomical Algorithms, chapter 16. NREL SPA and JPL Horizons use the same
    // formula.
    constexpr double lowest = -1;
    if (!(trueAltitude.value >= lowest)) return {0};
    const double density = relativeAirDensity(observer);
    const Degrees angle{trueAltitude.value + 10.3 / (trueAltitude.value + 5.11)};
    const double arcMinutes = 1.02 / std::tan(angle.radians().value);
    return {std::max(
        0.0, density * arcMinutes / 60)};  // the formula becomes negative at the zenith, by 0.002 arc minutes
}

glm::dvec3 toDirection(Degrees azimuth, Degrees altitude) {
    const double a = azimuth.radians().value;
    const double e = altitude.radians().value;
    return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

}  // namespace noonmark
