#include "core/sun/sun_events.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace noonmark {

namespace {

using namespace std::chrono;

// Almanacs and SPA define -0.833 deg (34' of refraction, 16' of half the disc) from the earth's centre; seen
// from its surface the sun is lower by its parallax.
constexpr double parallaxDeg = 8.794 / 3600;
constexpr double limbAltitudeDeg = -0.8333;
constexpr double horizonRefractionDeg = 34.0 / 60;  // in the default air
constexpr milliseconds halfDay = 12h;

double thresholdDeg(const Ephemeris& sun, SunriseRule rule, Degrees horizonDip) {
    if (rule == SunriseRule::centre) return 0;
    return computeSunriseAltitudeDeg(rule, sun.airDensity()) - parallaxDeg - horizonDip.value;
}

double altitudeAt(const Ephemeris& sun, Instant at) { return sun.at(at).altitude.value; }

/// Time until the sun passes due south or north, less than half a day either way. Zero only if its azimuth is
/// that of the meridian.
milliseconds untilTransit(const Ephemeris& sun, Instant at) {
    const double hourAngle = sun.hourAngle(at).value;
    return milliseconds{
        std::llround(-hourAngle / (2 * std::numbers::pi) * duration<double, std::milli>(24h).count())};
}

Instant transitNearest(const Ephemeris& sun, Instant noon) {
    Instant transit = noon;
    for (int i = 0; i < 4; ++i) transit += untilTransit(sun, transit);
    return transit;
}

/// Time of the highest sun, a little before or after the transit, near the poles by hours: golden section.
Instant highestBetween(const Ephemeris& sun, Instant from, Instant to) {
    constexpr double shrink = 1 / std::numbers::phi;
    while (to - from > 100ms) {
        const auto inner = milliseconds{std::llround(double((to - from).count()) * shrink)};
        if (altitudeAt(sun, to - inner) < altitudeAt(sun, from + inner)) {
            from = to - inner;
        } else {
            to = from + inner;
        }
    }
    return from + (to - from) / 2;
}

/// Time of the crossing between an instant with the sun up and one when it may be down; nothing if it is up
/// at both.
std::optional<Instant> crossing(const Ephemeris& sun, Instant up, Instant down, double altitudeDeg) {
    if (altitudeAt(sun, down) > altitudeDeg) return std::nullopt;
    while (abs(up - down) > 1ms) {
        const Instant middle = up + (down - up) / 2;
        (altitudeAt(sun, middle) > altitudeDeg ? up : down) = middle;
    }
    return up;
}

}  // namespace

SunEvents computeSunEvents(const Ephemeris& sun, Instant localMidnight, SunriseRule rule,
                           Degrees horizonDip) {
    SunEvents events;
    events.transit = transitNearest(sun, localMidnight + halfDay);
    const double altitudeDeg = thresholdDeg(sun, rule, horizonDip);
    const Instant highest = highestBetween(sun, events.transit - halfDay, events.transit + halfDay);
    if (altitudeAt(sun, highest) <= altitudeDeg) {
        events.kind = DayKind::polarNight;
        return events;
    }
    events.sunrise = crossing(sun, highest, events.transit - halfDay, altitudeDeg);
    events.sunset = crossing(sun, highest, events.transit + halfDay, altitudeDeg);
    if (!events.sunrise && !events.sunset) events.kind = DayKind::polarDay;
    return events;
}

double computeSunriseAltitudeDeg(SunriseRule rule, double airDensity) {
    if (rule == SunriseRule::centre) return 0;
    return limbAltitudeDeg + (1 - airDensity) * horizonRefractionDeg;
}

Degrees computeHorizonDip(double aboveHorizonM) {
    return {1.76 / 60 * std::sqrt(std::max(0.0, aboveHorizonM))};
}

SunEvents computeSunEvents(const Observer& observer, Instant localMidnight, SunriseRule rule,
                           Degrees horizonDip) {
    return computeSunEvents(Ephemeris::spanning(observer, localMidnight - days{1}, localMidnight + days{2}),
                            localMidnight, rule, horizonDip);
}

}  // namespace noonmark
