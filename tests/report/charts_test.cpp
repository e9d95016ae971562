#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>

#include "app/report/charts/carpet_chart.h"
#include "app/report/charts/month_bars.h"
#include "app/report/charts/timeline_chart.h"

namespace noonmark {
namespace {

using namespace std::chrono_literals;
using std::chrono::sys_days;

constexpr CivilDate midsummer{2026y, std::chrono::June, 21d};
const DayClock utc({ClockKind::fixed, 0}, Zone::named("UTC").value(), nullptr, 0);

// Half of 100 m2 is in the baseline's shadow from 6 h to 8 h; the scenario adds 20 m2 from 7 h on.
DayTimeline twoHours(CivilDate date = midsummer) {
    DayTimeline day{.day = date, .areaM2 = 100};
    for (int minute = 0; minute < 120; ++minute) {
        const double added = minute < 60 ? 0 : 20;
        day.steps.push_back({sys_days(date) + 6h + std::chrono::minutes(minute), 50, 50 + added, added, 0});
    }
    return day;
}

TEST(Charts, StepsOfAxesAreRound) {
    EXPECT_EQ(findNiceStep(1000, 4), 500);
    EXPECT_EQ(findNiceStep(800, 4), 200);
    EXPECT_DOUBLE_EQ(findNiceStep(0.37, 4), 0.1);
    const ChartAxis axis = makeAmountAxis(3127, {});
    EXPECT_EQ(axis.to, 4000);
    ASSERT_EQ(axis.ticks.size(), 5U);
    EXPECT_EQ(axis.ticks[4].text.toStdString(), "4,000");
    EXPECT_EQ(makeAmountAxis(0, {}).to, 1);
}

TEST(Charts, HoursAreLabelledAsFarApartAsThereIsRoom) {
    EXPECT_EQ(makeHourAxis(360, 1080, 1000).ticks.size(), 13U);  // 6 to 18 h, every hour
    EXPECT_EQ(makeHourAxis(360, 1080, 250).ticks.size(), 7U);    // every second hour
    EXPECT_EQ(makeHourAxis(360, 1080, 20).ticks.size(), 3U);     // 6, 12, 18 h at the least
}

TEST(Charts, ATimelineIsReadAtItsTime) {
    const TimelineChart chart = makeTimelineChart(twoHours(), 1, utc);
    EXPECT_EQ(chart.fromMin, 360);
    EXPECT_EQ(chart.toMin, 480);
    QImage image(400, 200, QImage::Format_RGB32);
    QPainter painter(&image);
    const Canvas canvas{painter, 1};
    const QRectF area(image.rect());
    const QRectF plot = plotIn(canvas, area);
    const auto at = [&](double share) {
        return findSampleAt(canvas, area, chart, {plot.left() + plot.width() * share, plot.center().y()});
    };
    ASSERT_TRUE(at(0.751));
    EXPECT_EQ(*at(0.751), 90U);
    EXPECT_EQ(describeSample(chart, 90).toStdString(),
              "07:30   incremental 20 m² (20 %), scenario 70 m² (70 %), baseline 50 m² (50 %)");
    EXPECT_FALSE(at(-0.01));
}

TEST(Charts, IncrementalShadowIsDrawnFromTheTimeItEnters) {
    const TimelineChart chart = makeTimelineChart(twoHours(), 1, utc);
    QImage image(400, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    const Canvas canvas{painter, 1};
    paintTimeline(canvas, QRectF(image.rect()), chart);
    painter.end();
    const auto isOrange = [&](double share) {
        QPainter again(&image);
        const QRectF plot = plotIn({again, 1}, QRectF(image.rect()));
        const QColor colour =
            image.pixelColor(int(plot.left() + plot.width() * share), int(plot.bottom()) - 6);
        return colour.red() > 180 && colour.blue() < 60;
    };
    EXPECT_FALSE(isOrange(0.27));
    EXPECT_TRUE(isOrange(0.77));
}

TEST(Charts, ACarpetHasTheMeanOfEachRowAndLeavesOutTheNight) {
    std::vector<DayTimeline> days{twoHours(), twoHours({2026y, std::chrono::June, 22d})};
    days[1].steps.resize(60);  // ends at 7 h
    days[0].steps.erase(days[0].steps.begin() + 65, days[0].steps.begin() + 70);
    const CarpetChart chart = makeCarpetChart(days, CarpetQuantity::incremental, 10, utc);
    ASSERT_EQ(chart.days.size(), 2U);
    ASSERT_EQ(chart.fromMin, 360);
    ASSERT_GE(chart.rows, 12U);
    EXPECT_EQ(chart.shares[0], 0);
    EXPECT_FLOAT_EQ(chart.shares[6], 0.2F);  // of the five steps that are left
    EXPECT_TRUE(std::isnan(chart.shares[chart.rows + 6]));
    const CarpetChart total = makeCarpetChart(days, CarpetQuantity::scenario, 120, utc);
    EXPECT_FLOAT_EQ(total.shares[0], float((60 * 0.5 + 55 * 0.7) / 115));
    EXPECT_EQ(describeCell(chart, {1, 6}).toStdString(), "2026-06-22, 07:00   not counted");
}

TEST(Charts, NothingToShowIsPainted) {
    QImage image(300, 150, QImage::Format_RGB32);
    QPainter painter(&image);
    const Canvas canvas{painter, 1};
    paintTimeline(canvas, QRectF(image.rect()), {});
    paintCarpet(canvas, QRectF(image.rect()), {});
    paintMonthBars(canvas, QRectF(image.rect()), {});
    EXPECT_FALSE(findSampleAt(canvas, QRectF(image.rect()), {}, {150, 80}));
    EXPECT_FALSE(findCellAt(canvas, QRectF(image.rect()), {}, {150, 80}));
}

}  // namespace
}  // namespace noonmark
