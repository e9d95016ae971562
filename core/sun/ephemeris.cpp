#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "core/sun/apparent_sun.h"
#include "core/sun/observer_frame.h"
#include "core/sun/time_scales.h"

namespace noonmark {

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
