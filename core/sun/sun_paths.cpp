#include "core/sun/sun_paths.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace noonmark {

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
