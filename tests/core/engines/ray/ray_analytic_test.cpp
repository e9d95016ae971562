#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "core/engines/ray/ray_reference.h"
#include "tests/core/engines/scenes.h"

/// Whole days of the real sun over scenes whose shadow follows from the slab test, step by step, in double.
namespace noonmark::tests {
namespace {

struct Site {
    const char* name;
    LonLat place;
    CivilDate date;
    int days;
    double stepMinutes;
};

void PrintTo(const Site& site, std::ostream* out) { *out << site.name; }

CivilDate date(int year, unsigned month, unsigned day) {
    return std::chrono::year_month_day{std::chrono::year{year}, std::chrono::month{month},
                                       std::chrono::day{day}};
}

SunSteps sunOf(const Site& site) {
    Period period;
    period.start = site.date;
    period.days = site.days;
    period.from = std::chrono::minutes{0};
    period.hours = 24;
    period.stepMinutes = site.stepMinutes;
    return computeSunSteps(period, {.place = site.place}).value();
}

/// The difference between the engine and the slab test.
struct Comparison {
    std::size_t cells = 0;
    std::size_t different = 0;  ///< cells whose minutes differ from the slab test
    std::size_t shaded = 0;     ///< cells with any shadow
};

// A cell may differ only by steps whose ray passes within 0.1 mm of a box's surface: its minutes must lie
// between those of boxes smaller and larger by that amount.
Comparison compare(const std::vector<Box3>& boxes, const Receivers& receivers, const SunSteps& sun) {
    const ShadowField field = traced(cityOf(boxes), receivers, sun);
    Comparison comparison;
    for (const std::uint32_t cell : receivers.cells) {
        const glm::dvec3 origin(placeRayOrigin(receivers.position(cell)));
        const auto grownBy = [&](double growM) {
            return minutesOf(sun,
                             [&](glm::dvec3 direction) { return inShadow(boxes, origin, direction, growM); });
        };
        const Minutes minimum = grownBy(-1e-4), exact = grownBy(0), maximum = grownBy(1e-4);
        const float tolerance = 1e-4F;
        EXPECT_GE(field.grossMin[cell], float(minimum.gross) - tolerance) << origin.x << ' ' << origin.y;
        EXPECT_LE(field.grossMin[cell], float(maximum.gross) + tolerance) << origin.x << ' ' << origin.y;
        EXPECT_GE(field.continuousMin[cell], float(minimum.continuous) - tolerance);
        EXPECT_LE(field.continuousMin[cell], float(maximum.continuous) + tolerance);
        ++comparison.cells;
        comparison.shaded += exact.gross > 0;
        comparison.different += std::abs(field.grossMin[cell] - float(exact.gross)) > tolerance;
    }
    return comparison;
}

class RayAnalytic : public testing::TestWithParam<Site> {};

TEST_P(RayAnalytic, OneBoxShadesTheMinutesThatTheSlabTestGives) {
    const Box3 box{{0, 0, 0}, {20, 15, 40}};
    const Receivers receivers = receiversOver(cityOf({box}), -90, -90, 110, 105, 3);
    const Comparison comparison = compare({box}, receivers, sunOf(GetParam()));
    EXPECT_GT(comparison.shaded, 400);
    EXPECT_LE(comparison.different * 500, comparison.cells)
        << comparison.different << " of " << comparison.cells;
}

INSTANTIATE_TEST_SUITE_P(Sites, RayAnalytic,
                         testing::Values(Site{"tropicsSunInTheNorth", {0, 10}, date(2026, 6, 21), 1, 1},
                                         Site{"tropicsSunInTheZenith", {0, 10}, date(2026, 4, 16), 1, 1},
                                         Site{"north65Summer", {25, 65}, date(2026, 6, 21), 1, 1},
                                         Site{"north65Winter", {25, 65}, date(2026, 12, 21), 1, 0.5},
                                         Site{"midnightSun", {20, 78}, date(2026, 6, 1), 2, 5},
                                         Site{"newYorkSpring", {-73.98, 40.75}, date(2026, 3, 21), 1, 1},
                                         Site{"southernSummer", {151.2, -33.9}, date(2026, 12, 21), 1, 1},
                                         Site{"southernWinterWeek", {151.2, -33.9}, date(2026, 6, 18), 7, 7}),
                         [](const auto& site) { return std::string(site.param.name); });

TEST(RayDays, SunStandsOnTheKnownSide) {
    // At local noon the shadow falls to the north in New York, to the south in Sydney, and to the south at 10
    // N in June.
    const auto shadeNorthOf = [](const Site& site) {
        const Box3 box{{0, 0, 0}, {20, 20, 40}};
        SunSteps sun = sunOf(site);
        std::size_t highest = 0;
        for (std::size_t i = 0; i < sun.steps.size(); ++i)
            if (sun.steps[i].altitudeDeg > sun.steps[highest].altitudeDeg) highest = i;
        const SunSteps noon =
            oneDay({{double(sun.steps[highest].azimuthDeg), double(sun.steps[highest].altitudeDeg)}});
        const Receivers receivers = receiversOver(cityOf({box}), -5, -5, 25, 25);
        const ShadowField field = traced(cityOf({box}), receivers, noon);
        return field.grossMin[cellAt(field.grid, 10, 21)] - field.grossMin[cellAt(field.grid, 10, -1)];
    };
    EXPECT_EQ(shadeNorthOf({"", {-73.98, 40.75}, date(2026, 3, 21), 1, 1}), 1);
    EXPECT_EQ(shadeNorthOf({"", {151.2, -33.9}, date(2026, 3, 21), 1, 1}), -1);
    EXPECT_EQ(shadeNorthOf({"", {0, 10}, date(2026, 6, 21), 1, 1}), -1);
}

TEST(RayDays, RandomBoxesOverADay) {
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        const std::vector<Box3> boxes = randomBoxes(seed, 5);
        const Receivers receivers = receiversOver(cityOf(boxes), -20, -20, 120, 120, 2);
        const Comparison comparison =
            compare(boxes, receivers, sunOf({"", {-73.98, 40.75}, date(2026, 3, 21), 1, 2}));
        EXPECT_LE(comparison.different * 50, comparison.cells)
            << comparison.different << " of " << comparison.cells;
    }
}

TEST(RayDays, PolarNightHasNoShadowAndNoSun) {
    const Site longyearbyen{"", {15.6, 78.2}, date(2026, 12, 20), 3, 10};
    const SunSteps sun = sunOf(longyearbyen);
    EXPECT_TRUE(sun.steps.empty());
    const City city = cityOf({{{0, 0, 0}, {20, 15, 40}}});
    const ShadowField field = traced(city, receiversOver(city, -10, -10, 0, 0), sun);
    EXPECT_EQ(field.days, 3);
    EXPECT_EQ(field.sunlitMinutesPerDay, 0);
    EXPECT_EQ(field.grossMin[5], 0);
    EXPECT_EQ(field.cost.rays, 0);
    EXPECT_GT(field.cost.skipped.at("steps with the sun below the horizon"), 0);
}

TEST(RayDays, DaysWithDifferentNumbersOfSteps) {
    // Days around the first sunrise after the polar night, which grow from no steps.
    const Site spring{"", {20, 70}, date(2026, 1, 10), 14, 5};
    const SunSteps sun = sunOf(spring);
    std::size_t shortest = 1000, longest = 0;
    for (const SunDay& day : sun.days) {
        shortest = std::min(shortest, std::size_t(day.count));
        longest = std::max(longest, std::size_t(day.count));
    }
    EXPECT_EQ(shortest, 0);
    EXPECT_GT(longest, 10);
    const Box3 box{{0, 0, 0}, {20, 15, 40}};
    const Comparison comparison = compare({box}, receiversOver(cityOf({box}), -60, 0, 80, 100, 5), sun);
    EXPECT_LE(comparison.different * 100, comparison.cells);
}

}  // namespace
}  // namespace noonmark::tests
