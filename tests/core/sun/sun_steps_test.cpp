#include "core/sun/sun_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/core/sun/sun_near.h"

namespace noonmark {
namespace {

using namespace tests;
using namespace std::chrono;

const Observer atNewYork = observerAt(40.75, -73.98);
const Observer atLongyearbyen = observerAt(78.22, 15.65);

Period periodIn(const std::string& zone, CivilDate start) {
    Period period;
    period.zone = zone;
    period.start = start;
    return period;
}

/// Properties of every result, whatever the period.
void expectSound(const SunSteps& sun) {
    std::size_t next = 0;
    std::size_t below = 0;
    for (const SunDay& day : sun.days) {
        EXPECT_EQ(day.first, next);
        next += day.count;
        below += day.belowHorizon;
        for (std::size_t i = day.first + 1; i < next; ++i) {
            EXPECT_GT(sun.steps[i].slot, sun.steps[i - 1].slot);
            EXPECT_GT(sun.steps[i].at, sun.steps[i - 1].at);
        }
    }
    EXPECT_EQ(next, sun.steps.size());
    EXPECT_EQ(below, sun.belowHorizon);
    for (const SunStep& step : sun.steps) {
        EXPECT_GT(step.altitudeDeg, 0);
        EXPECT_GE(step.azimuthDeg, 0);
        EXPECT_LT(step.azimuthDeg, 360);
        EXPECT_GE(step.slot, 0);
        EXPECT_NEAR(glm::length(step.direction), 1, 1e-6);
        const auto expected = toDirection({step.azimuthDeg}, {step.altitudeDeg});
        EXPECT_LT(glm::length(glm::dvec3(step.direction) - expected), 1e-6);
    }
}

SunSteps stepsOf(const Period& period, const Observer& observer) {
    auto sun = computeSunSteps(period, observer);
    EXPECT_TRUE(sun) << sun.error().text();
    expectSound(*sun);
    return std::move(*sun);
}

TEST(SunSteps, StandForHalfOpenIntervals) {
    const SunSteps sun = stepsOf(periodIn("America/New_York", 2026y / March / 21), atNewYork);
    ASSERT_EQ(sun.steps.size(), 360);
    EXPECT_EQ(sun.steps.front().at, utc(2026, 3, 21, 13));
    EXPECT_EQ(sun.steps.back().at, utc(2026, 3, 21, 18, 59));
    EXPECT_EQ(sun.steps.back().slot, 359);
    EXPECT_EQ(sun.sunlitMinutes(), 360);
    EXPECT_EQ(sun.belowHorizon, 0);
}

TEST(SunSteps, CanBeStopped) {
    std::stop_source stop;
    stop.request_stop();
    const auto sun =
        computeSunSteps(periodIn("America/New_York", 2026y / March / 21), atNewYork, stop.get_token());
    ASSERT_FALSE(sun);
    EXPECT_TRUE(isCancelled(sun.error()));
}

TEST(SunSteps, AreWhereTheSunIs) {
    Period period = periodIn("America/New_York", 2026y / March / 21);
    period.stepMinutes = 7;
    for (const bool refraction : {true, false}) {
        period.refraction = refraction;
        for (const SunStep& step : stepsOf(period, atNewYork).steps) {
            const SolarPosition exact = computeSolarPosition(atNewYork, step.at);
            const Degrees altitude = refraction ? exact.altitudeApparent : exact.altitude;
            EXPECT_NEAR(step.altitudeDeg, altitude.value, 3e-5);
            EXPECT_NEAR(step.azimuthDeg, exact.azimuth.value, 5e-5);
        }
    }
}

TEST(SunSteps, FillHoursThatTheStepDoesNotDivide) {
    struct Case {
        double hours, stepMinutes;
        std::size_t steps;
        double counted;
    };
    // 360 / 7 = 51.4, 360 / 240 = 1.5, 30 / 240 = 0.1
    for (const Case& asked :
         {Case{6, 7, 51, 360.0 / 51}, Case{6, 0.1, 3600, 0.1}, Case{6, 240, 2, 180}, Case{0.5, 240, 1, 30}}) {
        Period period = periodIn("America/New_York", 2026y / March / 21);
        period.hours = asked.hours;
        period.stepMinutes = asked.stepMinutes;
        const SunSteps sun = stepsOf(period, atNewYork);
        ASSERT_EQ(sun.steps.size(), asked.steps);
        EXPECT_DOUBLE_EQ(sun.stepMinutes, asked.counted);
        EXPECT_NEAR(sun.sunlitMinutes(), asked.hours * 60, 1e-9);
        EXPECT_NEAR(sun.maxOffADayMin, 0, 1e-9);
        const double lastS = (asked.hours * 60 - asked.counted) * 60;
        EXPECT_LE(secondsBetween(sun.steps.back().at, utc(2026, 3, 21, 13)), lastS + 0.01);
        EXPECT_GE(secondsBetween(sun.steps.back().at, utc(2026, 3, 21, 13)), lastS - 0.01);
    }
}

// Sunrise to sunset, computed here from the two events.
TEST(SunSteps, OfASolarWindowCountAllOfItsMinutes) {
    const CivilDate date = 2026y / December / 21;
    const Instant midnight = Zone::named("America/New_York")->instantAt(date, 0min);
    const SunEvents events = computeSunEvents(atNewYork, midnight, SunriseRule::upperLimb);
    const double minutes = duration<double, std::ratio<60>>(*events.sunset - *events.sunrise).count() - 180;
    ASSERT_NEAR(minutes, 375.2, 2);  // 9 h 15 min of daylight
    Period period = periodIn("America/New_York", date);
    period.window = SolarHours{90min, 90min};
    for (const double step : {1.0, 7.0, 60.0, 240.0}) {
        period.stepMinutes = step;
        const SunSteps sun = stepsOf(period, atNewYork);
        EXPECT_EQ(sun.steps.size(), std::size_t(std::lround(minutes / step))) << step;
        EXPECT_NEAR(sun.sunlitMinutes(), minutes, 1e-6) << step;
        EXPECT_NEAR(sun.countedMinutes, minutes, 1e-6) << step;
        // The last step begins one step before the window ends.
        const Instant end = *events.sunset - 90min;
        EXPECT_NEAR(secondsBetween(sun.steps.back().at, end), sun.stepMinutes * 60, 0.01) << step;
    }
}

TEST(SunSteps, OfManySolarWindowsCountAllOfTheirMinutes) {
    Period period = periodIn("America/New_York", 2026y / January / 1);
    period.days = 365;
    period.window = SolarHours{90min, 90min};
    double minutes = 0;
    for (int i = 0; i < 365; ++i) {
        const CivilDate date{sys_days{period.start} + days{i}};
        const Instant midnight = Zone::named(period.zone)->instantAt(date, 0min);
        const SunEvents events = computeSunEvents(atNewYork, midnight, SunriseRule::upperLimb);
        minutes += duration<double, std::ratio<60>>(*events.sunset - *events.sunrise).count() - 180;
    }
    for (const double step : {1.0, 10.0, 60.0}) {
        period.stepMinutes = step;
        const SunSteps sun = stepsOf(period, atNewYork);
        EXPECT_NEAR(sun.sunlitMinutes(), minutes, 0.01) << step;
        EXPECT_NEAR(sun.stepMinutes, step, step / 50) << step;
        EXPECT_GT(sun.maxOffADayMin, 0) << step;
        EXPECT_LE(sun.maxOffADayMin, step * 0.6) << step;
    }
}

TEST(SunSteps, OfOneInstantADay) {
    Period period = periodIn("America/New_York", 2026y / March / 6);
    period.days = 3;
    period.hours = 0;
    period.stepMinutes = 10;
    const SunSteps sun = stepsOf(period, atNewYork);
    EXPECT_EQ(sun.stepMinutes, 1);
    ASSERT_EQ(sun.steps.size(), 3);
    EXPECT_EQ(sun.steps[0].at, utc(2026, 3, 6, 14));
    EXPECT_EQ(sun.steps[2].at, utc(2026, 3, 8, 13));  // summer time
}

TEST(SunSteps, BeginAtTheWallClockOnDaysOfChange) {
    for (const auto& [date, first] : {std::pair{CivilDate{2026y / March / 8}, utc(2026, 3, 8, 13)},
                                      std::pair{CivilDate{2026y / November / 1}, utc(2026, 11, 1, 14)}}) {
        const SunSteps sun = stepsOf(periodIn("America/New_York", date), atNewYork);
        EXPECT_EQ(sun.steps.size(), 360);
        EXPECT_EQ(sun.steps.front().at, first);
    }
    Period night = periodIn("America/New_York", 2026y / March / 8);
    night.from = 0min;
    night.hours = 24;
    const SunSteps sun = stepsOf(night, atNewYork);
    EXPECT_EQ(sun.steps.size() + sun.belowHorizon, 1440);
}

TEST(SunSteps, LeapDayIsADay) {
    Period period = periodIn("America/New_York", 2028y / February / 28);
    period.days = 3;
    const SunSteps sun = stepsOf(period, atNewYork);
    ASSERT_EQ(sun.dayCount(), 3);
    EXPECT_EQ(sun.days[1].date, CivilDate{2028y / February / 29});
    EXPECT_EQ(sun.days[2].date, CivilDate{2028y / March / 1});
    EXPECT_EQ(sun.steps.size(), 3 * 360);
}

TEST(SunSteps, MidnightSunFillsTheWholeDay) {
    Period period = periodIn("Europe/Oslo", 2026y / June / 21);
    period.from = 0min;
    period.hours = 24;
    const SunSteps sun = stepsOf(period, atLongyearbyen);
    EXPECT_EQ(sun.steps.size(), 1440);
    EXPECT_EQ(sun.belowHorizon, 0);
    period.from = 20h;  // across midnight
    period.hours = 8;
    EXPECT_EQ(stepsOf(period, atLongyearbyen).steps.size(), 480);
}

TEST(SunSteps, PolarNightHasDaysWithoutSteps) {
    Period period = periodIn("Europe/Oslo", 2026y / December / 21);
    period.days = 2;
    const SunSteps sun = stepsOf(period, atLongyearbyen);
    EXPECT_TRUE(sun.steps.empty());
    ASSERT_EQ(sun.dayCount(), 2);
    EXPECT_EQ(sun.days[1].count, 0);
    EXPECT_EQ(sun.days[1].belowHorizon, 360);
    EXPECT_EQ(sun.belowHorizon, 720);
    EXPECT_EQ(sun.sunlitMinutes(), 0);
    period.window = SolarHours{};
    EXPECT_EQ(stepsOf(period, atLongyearbyen).belowHorizon, 0);
}

TEST(SunSteps, BelowTheHorizonLeaveAGapInTheSlots) {
    // Longyearbyen in April: 24 hours from noon to noon, with a short night in the middle.
    Period period = periodIn("Europe/Oslo", 2026y / April / 10);
    period.from = 12h;
    period.hours = 24;
    const SunSteps sun = stepsOf(period, atLongyearbyen);
    EXPECT_EQ(sun.steps.size() + sun.belowHorizon, 1440);
    EXPECT_GT(sun.belowHorizon, 0);
    int gaps = 0;
    for (std::size_t i = 1; i < sun.steps.size(); ++i) gaps += sun.steps[i].slot != sun.steps[i - 1].slot + 1;
    EXPECT_EQ(gaps, 1);
    EXPECT_EQ(sun.steps.back().slot, 1439);
}

TEST(SunSteps, RefractionLengthensTheDay) {
    Period period = periodIn("America/New_York", 2026y / March / 21);
    period.from = 0min;
    period.hours = 24;
    const std::size_t seen = stepsOf(period, atNewYork).steps.size();
    period.refraction = false;
    const std::size_t geometric = stepsOf(period, atNewYork).steps.size();
    // 29' of refraction, twice, with the sun rising by 15 cos 40.75 deg per hour.
    EXPECT_NEAR(double(seen - geometric), 2 * 60 * (29.0 / 60) / (15 * 0.7576), 2);
    EXPECT_NEAR(double(geometric), 12 * 60 + 4, 6);
}

TEST(SunSteps, OfASolarWindowAreCountedFromSunrise) {
    Period period = periodIn("America/New_York", 2026y / March / 7);
    period.days = 3;
    period.window = SolarHours{90min, 90min};
    const SunSteps sun = stepsOf(period, atNewYork);
    for (const SunDay& day : sun.days) {
        const Instant midnight = Zone::named(period.zone)->instantAt(day.date, 0min);
        const SunEvents events = computeSunEvents(atNewYork, midnight, SunriseRule::upperLimb);
        EXPECT_LE(secondsBetween(sun.steps[day.first].at, *events.sunrise + 90min), 0.01);
        const double length =
            duration<double, std::ratio<60>>(*events.sunset - *events.sunrise).count() - 180;
        EXPECT_EQ(day.count, std::uint32_t(std::lround(length)));
        EXPECT_EQ(day.belowHorizon, 0);
        EXPECT_EQ(sun.steps[day.first].slot, 0);
    }
}

TEST(SunSteps, WindowBeforeSunriseCountsTheStepsWithoutSun) {
    Period period = periodIn("America/New_York", 2026y / March / 21);
    period.window = SolarHours{-30min, -30min};
    period.window->rule = SunriseRule::centre;
    period.refraction = false;
    const SunSteps sun = stepsOf(period, atNewYork);
    EXPECT_NEAR(double(sun.belowHorizon), 60, 1);
    EXPECT_EQ(sun.steps.front().slot, int(std::ceil(30 / sun.stepMinutes)));
}

TEST(SunSteps, WindowThatEndsBeforeItBeginsIsEmpty) {
    Period period = periodIn("Europe/Oslo", 2026y / January / 20);
    period.window = SolarHours{90min, 90min};
    const SunSteps sun = stepsOf(period, observerAt(69.65, 18.96));  // Tromso: the sun is up for an hour
    EXPECT_EQ(sun.days.front().count, 0);
    EXPECT_EQ(sun.belowHorizon, 0);
}

TEST(SunSteps, WindowOfAPolarDayIsTheCivilDay) {
    Period period = periodIn("Europe/Oslo", 2026y / June / 21);
    period.window = SolarHours{90min, 90min};
    const SunSteps sun = stepsOf(period, atLongyearbyen);
    EXPECT_EQ(sun.steps.size(), 1440);
    EXPECT_EQ(sun.steps.front().at, utc(2026, 6, 20, 22));
}

TEST(SunSteps, WindowOfADayWithoutSunsetLastsToMidnight) {
    // Tromso in May: the days from the first night without sunset.
    Period period = periodIn("Europe/Oslo", 2026y / May / 10);
    period.days = 20;
    period.window = SolarHours{90min, 90min};
    const Observer tromso = observerAt(69.65, 18.96);
    const SunSteps sun = stepsOf(period, tromso);
    const Zone oslo = Zone::named(period.zone).value();
    int half = 0;
    for (const SunDay& day : sun.days) {
        const SunEvents events =
            computeSunEvents(tromso, oslo.instantAt(day.date, 0min), SunriseRule::upperLimb);
        if (!events.sunrise || events.sunset) continue;
        ++half;
        EXPECT_LE(secondsBetween(sun.steps[day.first].at, *events.sunrise + 90min), 0.01);
        EXPECT_LE(secondsBetween(sun.steps[day.first + day.count - 1].at, oslo.instantAt(day.date, 24h)),
                  120);
    }
    EXPECT_EQ(half, 1);
    EXPECT_EQ(sun.days.back().count, 1440);
}

TEST(SunSteps, SunStandsInTheNorthOfTheTropicsAndTheSouth) {
    Period period = periodIn("America/Bogota", 2026y / June / 21);
    for (const SunStep& step : stepsOf(period, observerAt(4.6, -74.08)).steps) EXPECT_GT(step.direction.y, 0);
    period = periodIn("Australia/Sydney", 2026y / June / 21);
    const SunSteps sydney = stepsOf(period, observerAt(-33.87, 151.21));
    EXPECT_GT(sydney.steps.front().direction.x, 0);
    EXPECT_LT(sydney.steps.front().azimuthDeg, 90);
    EXPECT_GT(sydney.steps.back().azimuthDeg, 270);
}

TEST(SunSteps, FarZonesKeepTheirDates) {
    const SunSteps sun =
        stepsOf(periodIn("Pacific/Kiritimati", 2026y / March / 21), observerAt(1.87, -157.4));
    EXPECT_EQ(sun.steps.front().at, utc(2026, 3, 20, 19));
    EXPECT_EQ(sun.steps.size(), 360);
    EXPECT_NEAR(sun.steps.front().azimuthDeg, 90, 3);
}

TEST(SunSteps, OfAYearAreEightHoursADay) {
    Period period = periodIn("America/New_York", 2026y / January / 1);
    period.days = 365;
    period.from = 8h;
    period.hours = 8;
    const SunSteps sun = stepsOf(period, atNewYork);
    EXPECT_EQ(sun.steps.size(), 175200);
    EXPECT_EQ(sun.dayCount(), 365);
    EXPECT_EQ(sun.days.back().date, CivilDate{2026y / December / 31});
}

TEST(SunSteps, WorkAtBothEndsOfTheirYears) {
    for (const char* zone : {"Pacific/Kiritimati", "Etc/GMT+12", "America/New_York"}) {
        for (const CivilDate date : {CivilDate{1900y / January / 1}, CivilDate{2100y / December / 31}}) {
            for (const auto& window : {std::optional<SolarHours>{}, std::optional{SolarHours{-12h, -12h}}}) {
                Period period = periodIn(zone, date);
                period.window = window;
                EXPECT_FALSE(stepsOf(period, atNewYork).days.empty());
            }
        }
    }
    EXPECT_FALSE(computeSunSteps(periodIn("UTC", 1899y / December / 31), atNewYork));
    EXPECT_FALSE(computeSunSteps(periodIn("UTC", 2101y / January / 1), atNewYork));
}

TEST(SunSteps, RefuseWhatIsOutOfRange) {
    Period period = periodIn("UTC", 2026y / January / 1);
    EXPECT_EQ(computeSunSteps(period, observerAt(91, 0)).error().where, "latitude");
    period.days = 3660;
    period.hours = 24;
    period.stepMinutes = 1.0 / 60;
    EXPECT_EQ(computeSunSteps(period, atNewYork).error().where, "step");  // 316 million steps
    period.days = 0;
    EXPECT_EQ(computeSunSteps(period, atNewYork).error().where, "days");
}

}  // namespace
}  // namespace noonmark
