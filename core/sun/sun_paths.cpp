#include "core/sun/sun_paths.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
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
        std::llround(-hourAngle / (2 * std::numbers::pi) * double(milliseconds(24h).count()))};
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

namespace {

using std::chrono::days;
using std::chrono::sys_days;

constexpr std::chrono::minutes pathStep{10};
constexpr int pathSights = 144;
constexpr days hourLineStep{5};
constexpr int hourLineSights = 73;
constexpr days civilMargin{2};  // of the civil days of every zone
constexpr std::chrono::day dayOfMonth{21};

struct SunSight {
    glm::dvec3 towards{0, 0, 1};
    double altitudeDeg = 0;
    [[nodiscard]] bool isUp() const { return altitudeDeg > 0; }
};

SunSight sightAt(const Ephemeris& sun, const SunPathQuestion& question, Instant at) {
    const SolarPosition position = sun.at(at);
    const Degrees altitude = question.refraction ? position.altitudeApparent : position.altitude;
    return {question.observer.frameFromPlace * toDirection(position.azimuth, altitude), altitude.value};
}

glm::dvec3 findHorizonBetween(const SunSight& a, const SunSight& b) {
    const double share = a.altitudeDeg / (a.altitudeDeg - b.altitudeDeg);
    return glm::normalize(glm::mix(a.towards, b.towards, share));
}

SunCurve makeClosed(const std::vector<SunSight>& cycle) {
    SunCurve curve{{}, true};
    for (const SunSight& sight : cycle) curve.towards.push_back(glm::normalize(sight.towards));
    return curve;
}

// The last sight is followed by the first. Begins where the sun is down, so that no curve is cut in two at
// the ends of the list.
std::vector<SunCurve> cutAtHorizon(const std::vector<SunSight>& cycle) {
    const auto down = std::ranges::find_if_not(cycle, &SunSight::isUp);
    if (down == cycle.end()) return {makeClosed(cycle)};
    const auto first = std::size_t(down - cycle.begin());
    std::vector<SunCurve> curves;
    for (std::size_t i = 1; i <= cycle.size(); ++i) {
        const SunSight& before = cycle[(first + i - 1) % cycle.size()];
        const SunSight& here = cycle[(first + i) % cycle.size()];
        if (!before.isUp() && here.isUp()) curves.emplace_back();
        if (before.isUp() != here.isUp()) curves.back().towards.push_back(findHorizonBetween(before, here));
        if (here.isUp()) curves.back().towards.push_back(glm::normalize(here.towards));
    }
    return curves;
}

std::vector<SunCurve> findPath(const Ephemeris& sun, const SunPathQuestion& question, Instant midnight) {
    std::vector<SunSight> day;
    for (int i = 0; i < pathSights; ++i) day.push_back(sightAt(sun, question, midnight + i * pathStep));
    return cutAtHorizon(day);
}

std::vector<SunCurve> findHourLine(const Ephemeris& sun, const SunPathQuestion& question, int hour) {
    const Instant first =
        sys_days{question.year / std::chrono::January / 1} + std::chrono::hours(hour) - question.clockOffset;
    std::vector<SunSight> year;
    for (int i = 0; i < hourLineSights; ++i) year.push_back(sightAt(sun, question, first + i * hourLineStep));
    return cutAtHorizon(year);
}

}  // namespace

Result<SunPaths> computeSunPaths(const SunPathQuestion& question) {
    const auto zone = Zone::named(question.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto sun =
        Ephemeris::over(question.observer, sys_days{question.year / std::chrono::January / 1} - civilMargin,
                        sys_days{question.year / std::chrono::December / 31} + civilMargin);
    if (!sun) return tl::make_unexpected(sun.error());
    SunPaths paths;
    for (unsigned month = 1; month <= 12; ++month) {
        const CivilDate date = question.year / std::chrono::month(month) / dayOfMonth;
        paths.months[month - 1] = findPath(*sun, question, zone->instantAt(date, std::chrono::minutes(0)));
    }
    for (int hour = 0; hour < 24; ++hour) paths.hours[std::size_t(hour)] = findHourLine(*sun, question, hour);
    return paths;
}

Result<std::vector<SunCurve>> computeSunPath(const SunPathQuestion& question, CivilDate date) {
    const auto zone = Zone::named(question.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const Instant midnight = zone->instantAt(date, std::chrono::minutes(0));
    const auto sun = Ephemeris::over(question.observer, midnight - civilMargin, midnight + civilMargin);
    if (!sun) return tl::make_unexpected(sun.error());
    return findPath(*sun, question, midnight);
}

}  // namespace noonmark
