#include "core/measures/outlines/day_isochrones.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace noonmark
