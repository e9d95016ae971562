#include "core/sun/period.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/sun/period_fields.h"

namespace noonmark {
namespace {

using namespace std::chrono;
using ::testing::HasSubstr;

Period newYork() {
    Period period;
    period.zone = "America/New_York";
    return period;
}

/// The field that `checked` reports; empty if it accepts the period.
template <class Change>
std::string fieldOfError(Change change) {
    Period period = newYork();
    change(period);
    const auto result = validate(period);
    return result ? "" : result.error().where;
}

TEST(Period, IsTakenAsItIsWhereItIsInRange) {
    const auto period = validate(newYork());
    ASSERT_TRUE(period);
    EXPECT_EQ(*period, newYork());
    EXPECT_EQ(fieldOfError([](Period& p) { p.hours = 0; }), "");
    EXPECT_EQ(fieldOfError([](Period& p) { p.hours = 24, p.from = 24h; }), "");
    EXPECT_EQ(fieldOfError([](Period& p) { p.days = 3660; }), "");
    EXPECT_EQ(fieldOfError([](Period& p) { p.stepMinutes = 1.0 / 60; }), "");
    EXPECT_EQ(fieldOfError([](Period& p) { p.window = SolarHours{-12h, -12h}; }), "");
}

TEST(Period, SaysWhichFieldIsOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(fieldOfError([](Period& p) { p.start = 2026y / February / 30; }), "start");
    EXPECT_EQ(fieldOfError([](Period& p) { p.start = 1899y / December / 31; }), "start");
    EXPECT_EQ(fieldOfError([](Period& p) { p.start = 2100y / December / 31, p.days = 2; }), "start");
    EXPECT_EQ(fieldOfError([](Period& p) { p.days = 0; }), "days");
    EXPECT_EQ(fieldOfError([](Period& p) { p.days = -1; }), "days");
    EXPECT_EQ(fieldOfError([](Period& p) { p.days = 3661; }), "days");
    EXPECT_EQ(fieldOfError([](Period& p) { p.from = -1min; }), "from");
    EXPECT_EQ(fieldOfError([](Period& p) { p.from = 24h + 1min; }), "from");
    EXPECT_EQ(fieldOfError([](Period& p) { p.hours = 24.1; }), "hours");
    EXPECT_EQ(fieldOfError([](Period& p) { p.hours = -1; }), "hours");
    EXPECT_EQ(fieldOfError([](Period& p) { p.hours = 1e-9; }), "hours");
    EXPECT_EQ(fieldOfError([=](Period& p) { p.hours = nan; }), "hours");
    EXPECT_EQ(fieldOfError([](Period& p) { p.stepMinutes = 0; }), "step");
    EXPECT_EQ(fieldOfError([](Period& p) { p.stepMinutes = 241; }), "step");
    EXPECT_EQ(fieldOfError([=](Period& p) { p.stepMinutes = nan; }), "step");
    EXPECT_EQ(fieldOfError([](Period& p) { p.window = SolarHours{13h, 0min}; }), "window");
    EXPECT_EQ(fieldOfError([](Period& p) { p.zone = "America/Gotham"; }), "zone");
}

TEST(PeriodText, SaysItInOneLine) {
    Period period = newYork();
    EXPECT_EQ(formatText(period), "2026-03-21, 1 day, 09:00 for 6 h, every 1 min, America/New_York");
    period.days = 365;
    period.hours = 0;
    period.refraction = false;
    EXPECT_EQ(formatText(period), "2026-03-21, 365 days, at 09:00, America/New_York, no refraction");
    period.window = SolarHours{90min, 90min};
    period.stepMinutes = 0.5;
    EXPECT_EQ(
        formatText(period),
        "2026-03-21, 365 days, sunrise+1.5h..sunset-1.5h, every 0.5 min, America/New_York, no refraction");
}

TEST(SolarHoursText, IsReadInItsForms) {
    const auto read = [](const char* text) { return parseSolarHours(text).value(); };
    EXPECT_EQ(read("sunrise+1.5h..sunset-1.5h"), (SolarHours{90min, 90min}));
    EXPECT_EQ(read("sunrise-30m..sunset+30m"), (SolarHours{-30min, -30min}));
    EXPECT_EQ(read("sunrise..sunset"), (SolarHours{}));
    EXPECT_EQ(read("+1h..-1h"), (SolarHours{60min, 60min}));
    EXPECT_EQ(read("90m..1.5h"), (SolarHours{90min, 90min}));
    EXPECT_EQ(read("sunrise + 20 min .. sunset"), (SolarHours{20min, 0min}));
    EXPECT_EQ(read("Sunrise..Sunset-2H"), (SolarHours{0min, 120min}));
    EXPECT_EQ(read(".."), (SolarHours{}));
}

TEST(SolarHoursText, RoundTrips) {
    for (int after = -720; after <= 720; after += 45) {
        for (int before = -720; before <= 720; before += 31) {
            const SolarHours window{minutes{after}, minutes{before}};
            EXPECT_EQ(parseSolarHours(formatText(window)).value(), window) << formatText(window);
        }
    }
}

TEST(SolarHoursText, SaysWhatItCannotRead) {
    for (const char* text :
         {"", "sunrise", "sunset..sunrise", "sunrise+1.5..sunset", "sunrise+h..sunset",
          "sunrise+1.5.5h..sunset", "sunrise+13h..sunset", "sunrise+1h..sunset-1h..", "09:00..15:00",
          "sunrise+0.33h..sunset", "sunrise++1h..sunset", "sunrise+1e1m..sunset", "sunrise+.h..sunset"}) {
        const auto window = parseSolarHours(text);
        ASSERT_FALSE(window) << text;
        EXPECT_THAT(window.error().text(), HasSubstr("Write it like"));
    }
}

// As a form fills them.
TEST(SolarHours, AreFieldsInHoursThatComeBack) {
    const SolarHours rule{90min, 45min, SunriseRule::centre};
    SolarHours read;
    for (const Field& field : solarHoursFields().rows())
        ASSERT_TRUE(field.set(&read, field.get(&rule))) << field.key;
    EXPECT_EQ(read, rule);
    const auto first = solarHoursFields().rows().front();
    EXPECT_EQ(first.get(&rule), Value(1.5));
}

}  // namespace
}  // namespace noonmark
