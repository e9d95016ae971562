#include "core/sun/solar_position.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "core/sun/apparent_sun.h"

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

namespace {

using namespace std::chrono;

// With nodes two days apart the cubic through four nodes differs from the sun by 0.000003 deg (mostly because
// of the moon's pull on the earth).
constexpr milliseconds spacing = days{2};
constexpr Instant earliest = sys_days{1900y / January / 1} - days{4};
constexpr Instant latest = sys_days{2101y / January / 1} + days{4};

/// The sun's vector between two nodes: a polynomial in the fraction of the way between them.
using Cubic = std::array<glm::dvec3, 4>;

/// Lagrange's cubic through nodes at -1, 0, 1 and 2.
Cubic cubicThrough(const glm::dvec3& before, const glm::dvec3& at, const glm::dvec3& next,
                   const glm::dvec3& after) {
    return {at, next - at / 2.0 - before / 3.0 - after / 6.0, (before + next) / 2.0 - at,
            (at - next) / 2.0 + (after - before) / 6.0};
}

std::vector<glm::dvec3> nodesFrom(Instant first, std::size_t count) {
    std::vector<glm::dvec3> nodes(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        nodes[i] = computeApparentSun(ttDays(first + spacing * std::int64_t(i)));
    });
    return nodes;
}

}  // namespace

struct Ephemeris::Table {
    ObserverFrame frame;
    double airDensity;
    Instant first;
    std::vector<Cubic> cubics;

    Table(const Observer& observer, Instant from, Instant to)
        : frame(observer), airDensity(relativeAirDensity(observer)), first(from) {
        const auto count = std::size_t((to - from) / spacing) + 1;
        const auto nodes = nodesFrom(from - spacing, count + 3);
        for (std::size_t i = 0; i < count; ++i) {
            cubics.push_back(cubicThrough(nodes[i], nodes[i + 1], nodes[i + 2], nodes[i + 3]));
        }
    }

    [[nodiscard]] glm::dvec3 sunAt(Instant at) const {
        const auto index =
            std::clamp<std::int64_t>((at - first) / spacing, 0, std::int64_t(cubics.size()) - 1);
        const double fraction = double((at - first - index * spacing).count()) / double(spacing.count());
        const Cubic& cubic = cubics[std::size_t(index)];
        return cubic[0] + fraction * (cubic[1] + fraction * (cubic[2] + fraction * cubic[3]));
    }
};

Ephemeris::Ephemeris() = default;
Ephemeris::~Ephemeris() = default;
Ephemeris::Ephemeris(Ephemeris&&) noexcept = default;
Ephemeris& Ephemeris::operator=(Ephemeris&&) noexcept = default;

Result<Ephemeris> Ephemeris::over(const Observer& observer, Instant from, Instant to) {
    if (const auto good = validate(observer); !good) return tl::make_unexpected(good.error());
    if (to < from)
        return failure("The end of the time span lies before its start", "time span", "Swap the two");
    if (from < earliest || to > latest) {
        return failure("The position of the sun is known for the years 1900 to 2100 only", "time span",
                       "Choose a date in these years");
    }
    return spanning(observer, from, to);
}

Ephemeris Ephemeris::spanning(const Observer& observer, Instant from, Instant to) {
    Ephemeris ephemeris;
    ephemeris.table_ = std::make_shared<const Table>(observer, from, to);
    return ephemeris;
}

SolarPosition Ephemeris::at(Instant at) const {
    return table_->frame.position(table_->sunAt(at), earthRotation(ut1Days(at)));
}

double Ephemeris::airDensity() const { return table_->airDensity; }

Radians Ephemeris::hourAngle(Instant at) const {
    return table_->frame.hourAngle(table_->sunAt(at), earthRotation(ut1Days(at)));
}

}  // namespace noonmark
