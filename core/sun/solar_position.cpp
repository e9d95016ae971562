#include "core/sun/solar_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/sun/apparent_sun.h"
#include "core/sun/observer_frame.h"
#include "core/sun/time_scales.h"

namespace noonmark {

namespace {

struct ObserverNumber {
    const char* name;
    double value;
    ValueRange range;
    const char* unit;
};

}  // namespace

Result<Observer> validate(const Observer& observer) {
    const ObserverNumber numbers[] = {
        {"longitude", observer.place.lonDeg, {-180, 180}, "degrees"},
        {"latitude", observer.place.latDeg, {-90, 90}, "degrees"},
        {"elevation", observer.elevationM, {-500, 9000}, "m"},
        {"pressure", observer.pressureHPa, Observer::pressureRangeHPa, "hPa"},
        {"temperature", observer.temperatureC, Observer::temperatureRangeC, "deg C"}};
    for (const ObserverNumber& number : numbers) {
        if (number.range.holds(number.value)) continue;
        return failure(fmt::format("{:g} {} is out of range", number.value, number.unit), number.name,
                       fmt::format("Give {:g} to {:g}", number.range.min, number.range.max));
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
