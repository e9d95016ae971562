#include "core/sun/sun_events.h"

#include <gtest/gtest.h>

#include <random>

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

}  // namespace
}  // namespace noonmark
