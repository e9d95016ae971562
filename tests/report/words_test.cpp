#include <gtest/gtest.h>

#include "app/report/sheets/study_text.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;

TEST(PeriodWords, OneDay) {
    Period period;
    period.zone = "America/New_York";
    EXPECT_EQ(describePeriod(period), "21 March 2026, 09:00 to 15:00, every 1 min, America/New_York");
}

TEST(PeriodWords, ManyDaysPastTheEndOfAMonth) {
    Period period;
    period.days = 30;
    EXPECT_EQ(describeDays(period), "21 March 2026 to 19 April 2026 (30 days)");
}

TEST(PeriodWords, MomentsNightsAndSolarWindows) {
    Period period;
    period.hours = 0;
    EXPECT_EQ(describeHours(period), "at 09:00");
    period.hours = 20;
    EXPECT_EQ(describeHours(period), "09:00 for 20 h, every 1 min");
    period.window = SolarHours{90min, 0min};
    EXPECT_EQ(describeHours(period), "sunrise + 90 min to sunset, every 1 min");
    period.window = SolarHours{-10min, 30min};
    EXPECT_EQ(describeHours(period), "sunrise - 10 min to sunset - 30 min, every 1 min");
}

TEST(StudyWords, NumbersAreGroupedAndHaveNoIdleZeros) {
    EXPECT_EQ(describeCount(1234567), "1,234,567");
    EXPECT_EQ(describeAmount(61234.5), "61,234.5");
    EXPECT_EQ(describeAmount(360), "360");
    EXPECT_EQ(describeAmount(3.2, 2), "3.2");
    EXPECT_EQ(describeAmount(100, 0), "100");
    EXPECT_EQ(describeLatLon({-73.98401, 40.754}), "40.75400 N, 73.98401 W");
    EXPECT_EQ(describeLatLon({151.2, -33.9}), "33.90000 S, 151.20000 E");
}

TEST(StudyWords, FiguresCarryTheirUnits) {
    const auto figures = computeFigures(tests::syntheticStudy());
    ASSERT_FALSE(figures.empty());
    EXPECT_EQ(figures[0].name, "Shadow area");
    EXPECT_EQ(figures[0].value, "3,833 m² (41.7 %)");
    EXPECT_EQ(figures[1].value, "150 min a day (41.7 %)");
}

TEST(StudyWords, ContinuousShadowThatWasNotCountedIsNoNumber) {
    QString text;
    for (const FigureText& figure : computeFigures(tests::grossOnly(tests::syntheticStudy())))
        text += figure.name + u'=' + figure.value + u';';
    EXPECT_TRUE(text.contains("Mean continuous=not counted;")) << text.toStdString();
    EXPECT_FALSE(text.contains("nan", Qt::CaseInsensitive)) << text.toStdString();
}

TEST(Words, SheetsWriteDatesInOneForm) {
    EXPECT_EQ(asOnSheets("2026-12-21"), "21 December 2026");
    EXPECT_EQ(asOnSheets("2026-12-21, trees as evergreens"), "21 December 2026, trees as evergreens");
    EXPECT_EQ(asOnSheets("Tower"), "Tower");
    const Sentence found{"On %1, %2 places have less.", {"2026-12-21", "3"}};
    EXPECT_EQ(formatText(asOnSheets(found)), "On 21 December 2026, 3 places have less.");
}

}  // namespace
}  // namespace noonmark
