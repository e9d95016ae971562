#include <gtest/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/measures/outlines/day_isochrones.h"
#include "core/sun/period.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {

namespace {

// A wall 200 m long from west to east and 20 m high, at the equator. On 21 December the sun stands in the
// south all day; at its noon, 66.6 deg high, the shadow reaches 20 / tan(66.6 deg) = 8.7 m to the north.
City cityWithWall() {
    City city = tests::cityOf({{{-100, -1, 0}, {100, 0, 20}}});
    city.frame = Frame({0, 0});
    return city;
}

SunSteps december() {
    Period day;
    day.start = {std::chrono::year{2026}, std::chrono::December, std::chrono::day{21}};
    day.from = std::chrono::hours(7);
    day.hours = 10;
    return computeDaylightSteps(day, {{0, 0}}, {}).value();
}

TEST(DayIsochrones, LinesOfMoreMinutesAreNearerToTheWall) {
    NoProgress progress;
    const auto day = traceDayIsochrones(cityWithWall(), december(),
                                        {{{-20, 1}, {20, 60}}, {60, 120, 240, 480}, {}}, progress, {});
    ASSERT_TRUE(day);
    double last = 60;
    for (const double level : {60.0, 120.0, 240.0, 480.0}) {
        double farthest = 0;
        for (const Isochrone& line : day->lines)
            for (const glm::vec2 point : line.points)
                if (line.level == level) farthest = std::max(farthest, double(point.y));
        EXPECT_GT(farthest, 0) << level;
        EXPECT_LT(farthest, last) << level;
        last = farthest;
    }
}

TEST(DayIsochrones, OnAPlaneHalfUpShadowsReachHalfAsFar) {
    NoProgress progress;
    const auto farthest = [&](std::optional<double> planeM) {
        const auto day = traceDayIsochrones(cityWithWall(), december(), {{{-20, 1}, {20, 60}}, {300}, planeM},
                                            progress, {});
        double north = 0;
        for (const Isochrone& line : day.value().lines)
            for (const glm::vec2 point : line.points) north = std::max(north, double(point.y));
        return north;
    };
    EXPECT_NEAR(farthest(10), farthest({}) / 2, 1.0);
    EXPECT_EQ(farthest(21), 0);
}

const Grid grid{-150, -100, 1, 300, 200};

std::vector<float> valuesOf(const auto& value) {
    std::vector<float> values;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            values.push_back(float(value(grid.centre(column, row))));
    return values;
}

double lengthOfLine(const Isochrone& line) {
    double length = 0;
    for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i)
        length += double(
            glm::distance(line.points[i], line.points[(i + line.points.size() - 1) % line.points.size()]));
    return length;
}

TEST(Isochrones, OfAConeAreCircles) {
    // 300 min at the tip, 4 min less each metre: 120 min at r = 45 m, 60 min at r = 60 m.
    const glm::dvec2 tip(3.3, -7.7);
    const auto cone = valuesOf([&](glm::dvec2 at) { return 300 - 4 * glm::distance(at, tip); });
    const std::vector<double> levels{120, 60};
    const auto lines = traceIsochrones(grid, cone, levels);
    ASSERT_EQ(lines.size(), 2U);
    for (const Isochrone& line : lines) {
        const double radius = (300 - line.level) / 4;
        EXPECT_TRUE(line.closed);
        EXPECT_NEAR(lengthOfLine(line), 2 * std::numbers::pi * radius, 0.5);
        for (const glm::vec2 point : line.points)
            EXPECT_NEAR(glm::distance(glm::dvec2(point), tip), radius, 0.05);
    }
    EXPECT_EQ(lines[0].level, 120);
    EXPECT_EQ(lines[1].level, 60);
}

TEST(Isochrones, KeepIslandsAndHoles) {
    // Two hills of which the lower one alone reaches 120 min: an island of its own; and a ring around a dip.
    const auto hills = valuesOf([](glm::dvec2 at) {
        return std::max({130 - glm::distance(at, glm::dvec2(-80, 0)),
                         160 - glm::distance(at, glm::dvec2(60, 0)), 0.0}) -
               std::max(0.0, 60 - 3 * glm::distance(at, glm::dvec2(60, 0)));
    });
    const std::vector<double> levels{120};
    const auto lines = traceIsochrones(grid, hills, levels);
    ASSERT_EQ(lines.size(), 3U);
    double length = 0;
    for (const Isochrone& line : lines) {
        EXPECT_TRUE(line.closed);
        length += lengthOfLine(line);
    }
    // Radii: 130 - r = 120: 10 m; 160 - r = 120: 40 m; 160 - r - 60 + 3 r = 120: 10 m.
    EXPECT_NEAR(length, 2 * std::numbers::pi * (10 + 40 + 10), 1.5);
}

TEST(Isochrones, EndAtTheEdgeAndAtCellsWithoutAValue) {
    // Values rise to the east: the line x = 40 from edge to edge, cut where cells have no value.
    const auto ramp = valuesOf([](glm::dvec2 at) {
        return std::abs(at.y) < 10 ? double(std::numeric_limits<float>::quiet_NaN()) : at.x;
    });
    const std::vector<double> levels{40};
    const auto lines = traceIsochrones(grid, ramp, levels);
    ASSERT_EQ(lines.size(), 2U);
    for (const Isochrone& line : lines) {
        EXPECT_FALSE(line.closed);
        EXPECT_NEAR(lengthOfLine(line), 90, 1.5);
        for (const glm::vec2 point : line.points) EXPECT_NEAR(point.x, 40, 0.01);
    }
}

TEST(Isochrones, ThereIsNoneAboveOrBelowAllValuesOrWithoutValues) {
    const std::vector<double> levels{-5, 500};
    EXPECT_TRUE(traceIsochrones(grid, valuesOf([](glm::dvec2) { return 30; }), levels).empty());
    const std::vector<float> none(grid.size(), std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(traceIsochrones(grid, none, levels).empty());
    EXPECT_TRUE(traceIsochrones(grid, std::vector<float>(3), levels).empty());
}

}  // namespace

}  // namespace noonmark
