#include "core/sun/solar_position.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "tests/core/sun/sun_near.h"

namespace noonmark {
namespace {

using namespace tests;

TEST(SolarPosition, SummerSolsticeNoonIsNinetyLessLatitudePlusObliquity) {
    // The sun's declination at the solstice of 2026 is 23.436 deg.
    const Instant transit = utc(2026, 6, 21, 16, 57, 50);
    const SolarPosition sun = computeSolarPosition(observerAt(40.75, -73.98), transit);
    EXPECT_NEAR(sun.altitude.value, 90 - 40.75 + 23.436, 0.005);
    EXPECT_NEAR(sun.azimuth.value, 180, 0.2);
}

TEST(SolarPosition, EquinoxSunRisesInTheEast) {
    // The equinox of 2026 is on March 20 at 14:46 UTC; the sun then rises on the equator at 129.7 W.
    const SolarPosition sun = computeSolarPosition(observerAt(0, -129.7), utc(2026, 3, 20, 14, 46));
    EXPECT_NEAR(sun.azimuth.value, 90, 0.005);
    EXPECT_NEAR(sun.altitude.value, 0, 0.1);
}

TEST(SolarPosition, StandsInTheZenithOfQuitoAtTheEquinox) {
    const SolarPosition sun = computeSolarPosition(observerAt(-0.18, -78.47), utc(2026, 3, 20, 17, 21, 20));
    EXPECT_GT(sun.altitude.value, 89.6);
    EXPECT_NEAR(sun.altitudeApparent.value, sun.altitude.value, 1e-3);
    EXPECT_LE(sun.altitudeApparent.value, 90);
}

TEST(SolarPosition, StandsInTheNorthAtNoonSouthOfIt) {
    EXPECT_LT(azimuthDifference(
                  computeSolarPosition(observerAt(-33.87, 151.21), utc(2026, 3, 21, 2, 2)).azimuth, {0}),
              1);
    EXPECT_LT(azimuthDifference(
                  computeSolarPosition(observerAt(4.6, -74.08), utc(2026, 6, 21, 16, 58)).azimuth, {0}),
              1);
}

TEST(SolarPosition, AzimuthPassesNorthWithoutA360) {
    // In Sydney around noon the sun moves from north-east over north to north-west.
    const Observer sydney = observerAt(-33.87, 151.21);
    bool east = false;
    bool west = false;
    for (int second = 0; second < 3600; second += 7) {
        const double azimuth =
            computeSolarPosition(sydney, utc(2026, 3, 21, 1, 30) + std::chrono::seconds{second})
                .azimuth.value;
        ASSERT_GE(azimuth, 0);
        ASSERT_LT(azimuth, 360);
        east |= azimuth < 10;
        west |= azimuth > 350;
    }
    EXPECT_TRUE(east && west);
}

TEST(SolarPosition, EarthTurnsFifteenDegreesAnHour) {
    const Observer pole = observerAt(89.9999, 0);
    const Degrees before = computeSolarPosition(pole, utc(2026, 6, 21, 3)).azimuth;
    const Degrees after = computeSolarPosition(pole, utc(2026, 6, 21, 4)).azimuth;
    EXPECT_NEAR(azimuthDifference(before, after), 15, 0.01);
}

TEST(SolarPosition, ParallaxLowersTheSunAtTheHorizonOnly) {
    // 8.8 arc seconds at the horizon: seen from 9000 m higher the sun shifts by 9000 / 1 au.
    Observer low = observerAt(40, 0);
    Observer high = low;
    high.elevationM = 9000;
    const Instant at = utc(2026, 3, 20, 12);
    EXPECT_LT(std::abs(computeSolarPosition(low, at).altitude.value -
                       computeSolarPosition(high, at).altitude.value),
              4e-6);
}

TEST(Refraction, FollowsTheFormulaAtKnownAltitudes) {
    const Observer standard = observerAt(0, 0);
    EXPECT_NEAR(refraction(standard, {0}).value, 28.98 / 60,
                0.0005);  // Meeus: 34.5' at apparent 0, 29' at true 0
    EXPECT_NEAR(refraction(standard, {45}).value, 1.015 / 60, 0.0002);
    EXPECT_NEAR(refraction(standard, {90}).value, 0, 1e-9);
    EXPECT_EQ(refraction(standard, {-1.001}).value, 0);
}

TEST(Refraction, GrowsWithPressureAndCold) {
    Observer observer = observerAt(0, 0);
    const double standard = refraction(observer, {5}).value;
    observer.pressureHPa = 505;
    EXPECT_NEAR(refraction(observer, {5}).value, standard / 2, 1e-12);
    observer.pressureHPa = 1010;
    observer.temperatureC = -30;
    EXPECT_GT(refraction(observer, {5}).value, standard);
    observer.pressureHPa = 0;
    EXPECT_EQ(refraction(observer, {5}).value, 0);
}

TEST(Refraction, NeverLowersAndFallsWithAltitude) {
    const Observer standard = observerAt(0, 0);
    double last = refraction(standard, {-1}).value;
    for (double altitude = -1; altitude <= 90; altitude += 0.01) {
        const double now = refraction(standard, {altitude}).value;
        EXPECT_GE(now, 0);
        EXPECT_LE(now, last);
        last = now;
    }
}

TEST(Direction, IsEastNorthUp) {
    EXPECT_LT(glm::length(toDirection({0}, {0}) - glm::dvec3(0, 1, 0)), 1e-15);
    EXPECT_LT(glm::length(toDirection({90}, {0}) - glm::dvec3(1, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(toDirection({123}, {90}) - glm::dvec3(0, 0, 1)), 1e-15);
    EXPECT_NEAR(toDirection({200}, {30}).z, 0.5, 1e-15);
}

TEST(Observer, IsCheckedFieldByField) {
    EXPECT_TRUE(validate(observerAt(-90, 180)));
    EXPECT_EQ(validate(observerAt(91, 0)).error().where, "latitude");
    EXPECT_EQ(validate(observerAt(0, 181)).error().where, "longitude");
    EXPECT_EQ(validate(observerAt(std::numeric_limits<double>::quiet_NaN(), 0)).error().where, "latitude");
    Observer hot = observerAt(0, 0);
    hot.temperatureC = 70;
    EXPECT_EQ(validate(hot).error().where, "temperature");
}

TEST(Ephemeris, AgreesWithSolarPositionFromPoleToPole) {
    std::mt19937 random(20260321);
    std::uniform_real_distribution<double> latitude(-90, 90);
    std::uniform_real_distribution<double> longitude(-180, 180);
    const Instant first = utc(1900, 1, 1);
    std::uniform_int_distribution<std::int64_t> start(0, (utc(2100, 6, 1) - first).count());
    for (int i = 0; i < 300; ++i) {
        const Observer observer = observerAt(latitude(random), longitude(random));
        const Instant from = first + std::chrono::milliseconds{start(random)};
        const Instant to = from + std::chrono::days{i % 30};
        const auto ephemeris = Ephemeris::over(observer, from, to);
        ASSERT_TRUE(ephemeris);
        std::uniform_int_distribution<std::int64_t> within(0, (to - from).count());
        for (int k = 0; k < 10; ++k) {
            const Instant at = from + std::chrono::milliseconds{within(random)};
            const SolarPosition exact = computeSolarPosition(observer, at);
            const SolarPosition quick = ephemeris->at(at);
            EXPECT_LT(separation(exact.azimuth, exact.altitude, quick.azimuth, quick.altitude), 0.00002);
            EXPECT_LT(std::abs(exact.altitude.value - quick.altitude.value), 0.00002);
        }
    }
}

TEST(Ephemeris, HoldsOverLeapSeconds) {
    const Observer observer = observerAt(40.75, -73.98);
    for (const Instant leap : {utc(1972, 1, 1), utc(1972, 7, 1), utc(2017, 1, 1)}) {
        const auto ephemeris =
            Ephemeris::over(observer, leap - std::chrono::days{3}, leap + std::chrono::days{3});
        ASSERT_TRUE(ephemeris);
        for (int minute = -4000; minute < 4000; minute += 13) {
            const Instant at = leap + std::chrono::minutes{minute};
            const SolarPosition exact = computeSolarPosition(observer, at);
            const SolarPosition quick = ephemeris->at(at);
            EXPECT_LT(separation(exact.azimuth, exact.altitude, quick.azimuth, quick.altitude), 0.00002);
        }
    }
}

TEST(Ephemeris, RefusesYearsItDoesNotKnow) {
    const Observer observer = observerAt(0, 0);
    EXPECT_FALSE(Ephemeris::over(observer, utc(1899, 12, 1), utc(1900, 1, 2)));
    EXPECT_FALSE(Ephemeris::over(observer, utc(2100, 12, 1), utc(2101, 2, 1)));
    EXPECT_FALSE(Ephemeris::over(observer, utc(2026, 1, 2), utc(2026, 1, 1)));
    EXPECT_FALSE(Ephemeris::over(observerAt(100, 0), utc(2026, 1, 1), utc(2026, 1, 2)));
    EXPECT_TRUE(Ephemeris::over(observer, utc(1900, 1, 1), utc(1900, 1, 1)));
    EXPECT_TRUE(Ephemeris::over(observer, utc(2100, 12, 31), utc(2101, 1, 1)));
}

}  // namespace
}  // namespace noonmark
