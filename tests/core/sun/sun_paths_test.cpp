#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/trigonometric.hpp>
#include <random>

#include "core/sun/sun_paths.h"
#include "tests/core/sun/sun_near.h"

namespace noonmark {

namespace {

using namespace tests;
using namespace std::chrono_literals;
using std::chrono::days;

const Observer longyearbyen = observerAt(78.22, 15.65);
const Observer tromso = observerAt(69.65, 18.96);

SunEvents eventsAt(const Observer& observer, Instant localMidnight) {
    return computeSunEvents(observer, localMidnight, SunriseRule::upperLimb);
}

double altitudeAt(const Observer& observer, Instant at) {
    return computeSolarPosition(observer, at).altitude.value;
}

TEST(SunEvents, CrossTheThresholdOfTheirRule) {
    const Observer newYork = observerAt(40.75, -73.98);
    for (const auto& [rule, altitude] :
         {std::pair{SunriseRule::upperLimb, -0.8357}, std::pair{SunriseRule::centre, 0.0}}) {
        const SunEvents events = computeSunEvents(newYork, utc(2026, 3, 21, 4), rule);
        ASSERT_TRUE(events.sunrise && events.sunset);
        EXPECT_NEAR(altitudeAt(newYork, *events.sunrise), altitude, 1e-4);
        EXPECT_NEAR(altitudeAt(newYork, *events.sunset), altitude, 1e-4);
        EXPECT_LT(*events.sunrise, events.transit);
        EXPECT_LT(events.transit, *events.sunset);
    }
}

// Without air the limb is half a disc (16') above the centre, and its parallax lower.
TEST(SunEvents, RefractionOfSunriseFollowsTheAir) {
    Observer airless = observerAt(40.75, -73.98);
    airless.pressureHPa = 0;
    const SunEvents events = eventsAt(airless, utc(2026, 3, 21, 4));
    EXPECT_NEAR(altitudeAt(airless, *events.sunrise), -16.0 / 60 - 8.794 / 3600, 1e-4);
    Observer cold = observerAt(40.75, -73.98);
    cold.temperatureC = -40;
    const SunEvents early = eventsAt(cold, utc(2026, 3, 21, 4));
    EXPECT_NEAR(altitudeAt(cold, *early.sunrise), -(34 * 283.0 / 233 + 16) / 60 - 8.794 / 3600, 1e-4);
}

// 100 m above the sea: 17.6' (Nautical Almanac).
TEST(SunEvents, TheDipOfTheHorizonMakesTheDayLonger) {
    const Observer tower = observerAt(40.75, -73.98);
    const SunEvents events =
        computeSunEvents(tower, utc(2026, 3, 21, 4), SunriseRule::upperLimb, computeHorizonDip(100));
    EXPECT_NEAR(altitudeAt(tower, *events.sunrise), -0.8357 - 17.6 / 60, 1e-4);
    EXPECT_NEAR(altitudeAt(tower, *events.sunset), -0.8357 - 17.6 / 60, 1e-4);
}

TEST(SunEvents, UpperLimbRisesBeforeTheCentre) {
    const Observer quito = observerAt(-0.18, -78.47);
    const auto limb = computeSunEvents(quito, utc(2026, 3, 20, 5), SunriseRule::upperLimb);
    const auto centre = computeSunEvents(quito, utc(2026, 3, 20, 5), SunriseRule::centre);
    EXPECT_NEAR(secondsBetween(*limb.sunrise, *centre.sunrise), 0.8357 / 15 * 3600, 1);
}

TEST(SunEvents, TransitIsTheHighestPointButForSeconds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> latitude(-60, 60);
    std::uniform_real_distribution<double> longitude(-180, 180);
    for (int i = 0; i < 100; ++i) {
        const Observer observer = observerAt(latitude(random), longitude(random));
        const Instant transit = eventsAt(observer, utc(2026, 1, 1) + days{i * 3}).transit;
        const double highest = altitudeAt(observer, transit);
        EXPECT_GT(highest, altitudeAt(observer, transit - 2min));
        EXPECT_GT(highest, altitudeAt(observer, transit + 2min));
    }
}

TEST(SunEvents, TransitIsTheOneNearestToNoonAtAnyLongitudeAndMidnight) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> latitude(-89, 89);
    std::uniform_real_distribution<double> longitude(-180, 180);
    std::uniform_int_distribution<int> minute(0, 525600);
    for (int i = 0; i < 300; ++i) {
        const Observer observer = observerAt(latitude(random), longitude(random));
        const Instant midnight = utc(2026, 1, 1) + std::chrono::minutes{minute(random)};
        const SunEvents events = eventsAt(observer, midnight);
        EXPECT_LE(secondsBetween(events.transit, midnight + 12h), 43200 + 1100);
        const double azimuth = computeSolarPosition(observer, events.transit).azimuth.value;
        EXPECT_LT(std::abs(std::remainder(azimuth, 180.0)), 0.02);
        EXPECT_LE(secondsBetween(events.sunrise.value_or(events.transit), events.transit), 43200);
        EXPECT_LE(secondsBetween(events.sunset.value_or(events.transit), events.transit), 43200);
    }
}

TEST(SunEvents, BothSidesOfTheDateLineAgree) {
    const Instant midnight = utc(2026, 5, 5, 12);
    const SunEvents west = eventsAt(observerAt(-16.8, 180), midnight);
    const SunEvents east = eventsAt(observerAt(-16.8, -180), midnight);
    EXPECT_EQ(west.transit, east.transit);
    EXPECT_EQ(west.sunrise, east.sunrise);
    EXPECT_EQ(west.sunset, east.sunset);
}

TEST(SunEvents, PolarDayAndNight) {
    const SunEvents summer = eventsAt(longyearbyen, utc(2026, 6, 20, 22));
    EXPECT_EQ(summer.kind, DayKind::polarDay);
    EXPECT_FALSE(summer.sunrise || summer.sunset);
    EXPECT_NEAR(secondsBetween(summer.transit, utc(2026, 6, 21, 10, 59, 15)), 0, 30);
    const SunEvents winter = eventsAt(longyearbyen, utc(2026, 12, 20, 23));
    EXPECT_EQ(winter.kind, DayKind::polarNight);
    EXPECT_FALSE(winter.sunrise || winter.sunset);
    EXPECT_EQ(eventsAt(observerAt(-78, 166.7), utc(2026, 6, 20, 12)).kind, DayKind::polarNight);
}

// The kinds of day in order from the first sunrise after midnight sun: days with sunrise and sunset, perhaps
// one with only one of them, then neither.
TEST(SunEvents, KindsChangeInOrderThroughThePolarYear) {
    int changes = 0;
    DayKind last = eventsAt(tromso, utc(2026, 1, 1)).kind;
    EXPECT_EQ(last, DayKind::polarNight);
    for (int day = 1; day < 365; ++day) {
        const DayKind kind = eventsAt(tromso, utc(2026, 1, 1) + days{day}).kind;
        changes += kind != last;
        last = kind;
    }
    EXPECT_EQ(changes, 4);  // night, ordinary, day, ordinary, night
}

TEST(SunEvents, SunThatRisesAndStaysUpHasNoSunset) {
    int half = 0;
    for (double latitude = 66; latitude < 80; latitude += 0.1) {
        const auto ephemeris = Ephemeris::over(observerAt(latitude, 0), utc(2026, 3, 30), utc(2026, 6, 30));
        ASSERT_TRUE(ephemeris);
        for (int day = 90; day < 175; ++day) {
            const auto events =
                computeSunEvents(*ephemeris, utc(2026, 1, 1) + days{day}, SunriseRule::upperLimb);
            if (events.sunrise.has_value() == events.sunset.has_value()) continue;
            EXPECT_EQ(events.kind, DayKind::ordinary);
            EXPECT_FALSE(events.sunset) << "in spring the sun rises before it stays up";
            EXPECT_GT(ephemeris->at(events.transit + 12h).altitude.value, -0.836);
            ++half;
        }
    }
    EXPECT_GT(half, 5);
}

TEST(SunEvents, SurvivesThePolesAndFarYears) {
    for (const double latitude : {90.0, -90.0, 89.999}) {
        EXPECT_EQ(eventsAt(observerAt(latitude, 0), utc(2026, 6, 21)).kind,
                  latitude > 0 ? DayKind::polarDay : DayKind::polarNight);
        eventsAt(observerAt(latitude, 0), utc(2026, 3, 18));
    }
    eventsAt(observerAt(40, 0), utc(1500, 1, 1));
    eventsAt(observerAt(40, 0), utc(2500, 1, 1));
}

TEST(SunEvents, FromAnEphemerisAreTheSame) {
    const Observer newYork = observerAt(40.75, -73.98);
    const Instant first = utc(2026, 1, 1, 5);
    const auto ephemeris = Ephemeris::over(newYork, first - days{1}, first + days{366});
    ASSERT_TRUE(ephemeris);
    for (int day = 0; day < 365; day += 9) {
        const SunEvents fromYear = computeSunEvents(*ephemeris, first + days{day}, SunriseRule::upperLimb);
        const SunEvents alone = eventsAt(newYork, first + days{day});
        EXPECT_LE(secondsBetween(*fromYear.sunrise, *alone.sunrise), 0.01);
        EXPECT_LE(secondsBetween(fromYear.transit, alone.transit), 0.01);
        EXPECT_LE(secondsBetween(*fromYear.sunset, *alone.sunset), 0.01);
    }
}

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
        double minimum = 2;
        for (const SunCurve& curve : curves)
            for (const glm::dvec3& towards : curve.towards)
                minimum = std::min(minimum, glm::distance(towards, expected));
        return minimum;
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
