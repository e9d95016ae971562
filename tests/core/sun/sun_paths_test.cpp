#include "core/sun/sun_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "tests/core/sun/sun_near.h"

namespace noonmark {
namespace {

using namespace tests;
using namespace std::chrono_literals;
using testing::IsEmpty;
using testing::SizeIs;

SunPaths pathsAt(double latDeg, double lonDeg = 0) {
    return computeSunPaths({.observer = observerAt(latDeg, lonDeg)}).value();
}

glm::dvec3 highestOf(const std::vector<SunCurve>& curves) {
    return std::ranges::max(curves.at(0).towards, {}, &glm::dvec3::z);
}

double sineOf(double altitudeDeg) { return std::sin(glm::radians(altitudeDeg)); }

TEST(SunPaths, PassTheZenithOfTheEquatorAtTheEquinox) {
    const auto march = pathsAt(0).months[2];
    ASSERT_THAT(march, SizeIs(1));
    EXPECT_GT(highestOf(march).z, sineOf(88.5)) << "half a step of ten minutes is 1.25 degrees";
    const auto& path = march[0].towards;
    EXPECT_FALSE(march[0].closed);
    EXPECT_LT(glm::distance(path.front(), {1, 0, 0}), 0.02) << "rises in the east";
    EXPECT_LT(glm::distance(path.back(), {-1, 0, 0}), 0.02) << "sets in the west";
}

TEST(SunPaths, StandInTheNorthAtNoonInTheSouth) {
    const SunPaths sydney = pathsAt(-33.87, 151.2);
    const glm::dvec3 june = highestOf(sydney.months[5]), december = highestOf(sydney.months[11]);
    EXPECT_GT(june.y, 0.5);
    EXPECT_GT(december.y, 0);
    EXPECT_NEAR(june.z, sineOf(90 - 33.87 - 23.44), 0.01);
    EXPECT_NEAR(december.z, sineOf(90 - 33.87 + 23.44), 0.01);
    const glm::dvec3 paris = highestOf(pathsAt(48.86, 2.35).months[5]);
    EXPECT_LT(paris.y, 0);
    EXPECT_NEAR(paris.z, sineOf(90 - 48.86 + 23.44), 0.01);
}

TEST(SunPaths, AreClosedWhereTheSunDoesNotSet) {
    const SunPaths longyearbyen = pathsAt(78.22, 15.65);
    const auto& june = longyearbyen.months[5];
    ASSERT_THAT(june, SizeIs(1));
    EXPECT_TRUE(june[0].closed);
    const glm::dvec3 lowest = std::ranges::min(june[0].towards, {}, &glm::dvec3::z);
    EXPECT_NEAR(lowest.z, sineOf(78.22 + 23.44 - 90), 0.003);
    EXPECT_GT(lowest.y, 0.9) << "at midnight in the north";
    EXPECT_THAT(longyearbyen.months[11], IsEmpty()) << "polar night";
    EXPECT_TRUE(longyearbyen.months[2].at(0).closed == false);
}

TEST(SunPaths, AreNotCutAtTheMidnightOfTheZone) {
    // On this clock the day begins when the sun is high over the place.
    const SunPathQuestion elsewhere{.observer = observerAt(50, 15), .zone = "Pacific/Auckland"};
    const auto day = computeSunPath(elsewhere, 2026y / std::chrono::June / 21).value();
    ASSERT_THAT(day, SizeIs(1));
    EXPECT_NEAR(day[0].towards.front().z, 0, 0.01);
    EXPECT_NEAR(day[0].towards.back().z, 0, 0.01);
    EXPECT_GT(day[0].towards.front().x, 0.5);
    EXPECT_LT(day[0].towards.back().x, -0.5);
}

TEST(SunPaths, HourLinesAreWhereTheSunStandsAtThatHour) {
    SunPathQuestion newYork{.observer = observerAt(40.76, -73.98), .clockOffset = -4h};
    const SunPaths paths = computeSunPaths(newYork).value();
    // 34 steps of 5 days after 1 January.
    const SolarPosition sun = computeSolarPosition(newYork.observer, utc(2026, 6, 20, 19));
    const glm::dvec3 expected = toDirection(sun.azimuth, sun.altitudeApparent);
    const auto nearest = [&](const std::vector<SunCurve>& curves) {
        double least = 2;
        for (const SunCurve& curve : curves)
            for (const glm::dvec3& towards : curve.towards)
                least = std::min(least, glm::distance(towards, expected));
        return least;
    };
    EXPECT_LT(nearest(paths.hours[15]), 1e-5);
    EXPECT_GT(nearest(paths.hours[14]), 0.1);
    EXPECT_TRUE(paths.hours[12].at(0).closed) << "the sun is up at noon all year";
    EXPECT_THAT(paths.hours[0], IsEmpty());
    EXPECT_FALSE(paths.hours[19].at(0).closed) << "only in summer";
    newYork.clockOffset = 0h;
    EXPECT_LT(nearest(computeSunPaths(newYork).value().hours[19]), 1e-5) << "the same instants in UTC";
}

TEST(SunPaths, FollowTheFrameOfTheGeometryAndRefraction) {
    SunPathQuestion question{.observer = observerAt(45, 0)};
    const glm::dvec3 plain = highestOf(computeSunPaths(question).value().months[5]);
    question.observer.frameFromPlace = glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1);  // a quarter to the left
    const glm::dvec3 turned = highestOf(computeSunPaths(question).value().months[5]);
    EXPECT_NEAR(turned.x, -plain.y, 1e-9);
    EXPECT_NEAR(turned.z, plain.z, 1e-9);
    question.refraction = false;
    EXPECT_LT(highestOf(computeSunPaths(question).value().months[11]).z, highestOf(pathsAt(45).months[11]).z);
}

TEST(SunPaths, RefuseAnUnknownZoneAndAYearWithoutEphemeris) {
    EXPECT_FALSE(computeSunPaths({.zone = "Europe/Atlantis"}));
    EXPECT_FALSE(computeSunPaths({.year = std::chrono::year{1850}}));
    EXPECT_TRUE(computeSunPaths({.year = std::chrono::year{1900}}));
    EXPECT_TRUE(computeSunPaths({.year = std::chrono::year{2100}}));
}

}  // namespace
}  // namespace noonmark
