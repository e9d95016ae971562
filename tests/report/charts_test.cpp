#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>

#include "app/report/charts/bar_chart.h"
#include "app/report/charts/carpet_chart.h"
#include "app/report/charts/chart_axes.h"
#include "app/report/charts/timeline_chart.h"
#include "app/report/maps/style.h"

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
    const ChartAxis axis = makeAmountAxis(0, 3127, {});
    EXPECT_EQ(axis.to, 4000);
    ASSERT_EQ(axis.ticks.size(), 5U);
    EXPECT_EQ(axis.ticks[4].text.toStdString(), "4,000");
    EXPECT_EQ(makeAmountAxis(0, 0, {}).to, 1);
    EXPECT_EQ(makeAmountAxis(0, 0.3, {}).ticks.back().text.toStdString(), "0.3");
    const ChartAxis both = makeAmountAxis(-150, 320, {});  // steps of 200
    EXPECT_EQ(both.from, -200);
    EXPECT_EQ(both.to, 400);
    EXPECT_EQ(both.ticks.front().text.toStdString(), "-200");
    EXPECT_EQ(both.ticks[1].text.toStdString(), "0");
}

TEST(Charts, HoursAreLabelledAsFarApartAsThereIsRoom) {
    EXPECT_EQ(makeHourAxis(360, 1080, 1000).ticks.size(), 13U);  // 6 to 18 h, every hour
    EXPECT_EQ(makeHourAxis(360, 1080, 250).ticks.size(), 7U);    // every second hour
    EXPECT_EQ(makeHourAxis(360, 1080, 20).ticks.size(), 3U);     // 6, 12, 18 h at the least
}

TEST(Charts, ALegendStaysWithinANarrowPlot) {
    QImage image(400, 60, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    const QRectF plot(30, 30, 150, 25);
    paintKeys({painter, 1}, plot,
              {{QStringLiteral("Baseline"), Qt::red},
               {QStringLiteral("Scenario"), Qt::blue, true},
               {QStringLiteral("Incremental"), Qt::green}});
    int last = 0;
    for (int x = 0; x < image.width(); ++x)
        for (int y = 0; y < image.height(); ++y)
            if (image.pixelColor(x, y) != QColor(Qt::white)) last = x;
    EXPECT_GT(last, 130);
    EXPECT_LE(last, int(plot.right()) + 1);
}

TEST(Charts, ATimelineIsReadAtItsTime) {
    const TimelineChart chart = makeTimelineChart(twoHours(), 1, utc);
    EXPECT_EQ(chart.fromMin, 360);
    EXPECT_EQ(chart.toMin, 480);
    const QRectF area(0, 0, 400, 200);
    const QRectF plot = plotIn(area, 1);
    const auto at = [&](double share) {
        return findSampleAt(area, 1, chart, {plot.left() + plot.width() * share, plot.center().y()});
    };
    ASSERT_TRUE(at(0.751));
    EXPECT_EQ(*at(0.751), 90U);
    EXPECT_EQ(describeSample(chart, 90).toStdString(),
              "07:30   incremental 20 m², 20 %; scenario 70 m², 70 %; baseline 50 m², 50 %");
    EXPECT_FALSE(at(-0.01));
}

// 1 sq ft = 0.09290304 m2: 20 m2 = 215.3, 70 m2 = 753.5 and 50 m2 = 538.2 sq ft.
TEST(Charts, ReadingsAreInTheUnitsOfTheProject) {
    TimelineChart chart = makeTimelineChart(twoHours(), 1, utc, UnitSystem::imperial);
    EXPECT_EQ(describeSample(chart, 90).toStdString(),
              "07:30   incremental 215 sq ft, 20 %; scenario 753 sq ft, 70 %; baseline 538 sq ft, 50 %");
    chart.units = UnitSystem::both;
    chart.samples[90].gainedM2 = 5;  // 53.8 sq ft
    EXPECT_EQ(describeSample(chart, 90).toStdString(),
              "07:30   incremental 20 m² (215 sq ft), 20 %; scenario 70 m² (753 sq ft), 70 %; baseline 50 m² "
              "(538 sq ft), 50 %; sun gained 5 m² (54 sq ft), 5.0 %");
    EXPECT_EQ(areaUnitOf(UnitSystem::imperial).name.toStdString(), "sq ft");
    EXPECT_DOUBLE_EQ(areaUnitOf(UnitSystem::imperial).squareMetres, 0.09290304);
    EXPECT_EQ(areaUnitOf(UnitSystem::both).name.toStdString(), "m²");
}

TEST(Charts, UnitsChangeTheScaleOfAChartAndNotItsShape) {
    const auto orangeRows = [](UnitSystem units) {
        QImage image(400, 200, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        paintTimeline({painter, 1}, QRectF(image.rect()), makeTimelineChart(twoHours(), 1, utc, units));
        painter.end();
        const QRectF plot = plotIn(QRectF(image.rect()), 1);
        int rows = 0;
        for (int y = int(plot.top()); y < int(plot.bottom()); ++y)
            rows += image.pixelColor(int(plot.left() + plot.width() * 0.77), y) == shade::incremental ? 1 : 0;
        return rows;
    };
    // 20 of the 100 m2 that the plot of 169 points is high: 33.8, less its border and a grid line.
    EXPECT_NEAR(orangeRows(UnitSystem::metric), 33, 2.5);
    EXPECT_NEAR(orangeRows(UnitSystem::imperial), 33, 2.5);
}

TEST(Charts, StepsOfAThinnedDayAreFoundInTheDay) {
    DayTimeline day = twoHours();
    for (std::size_t i = day.steps.size(); i-- > 0;)
        if (i % 5 != 0) day.steps.erase(day.steps.begin() + std::ptrdiff_t(i));
    EXPECT_EQ(stepMinutesOf(day, 1), 5);
    EXPECT_EQ(makeTimelineChart(day, 1, utc).stepMinutes, 5);
    day.steps.resize(1);
    EXPECT_EQ(stepMinutesOf(day, 1), 1);
}

TEST(Charts, IncrementalShadowIsDrawnFromTheTimeItEnters) {
    const TimelineChart chart = makeTimelineChart(twoHours(), 1, utc);
    QImage image(400, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    const Canvas canvas{painter, 1};
    paintTimeline(canvas, QRectF(image.rect()), chart);
    painter.end();
    const auto isOrange = [&](double share) {  // on top of the baseline's half of the place
        const QRectF plot = plotIn(QRectF(image.rect()), 1);
        const QColor colour =
            image.pixelColor(int(plot.left() + plot.width() * share), int(plot.center().y()) - 6);
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

TEST(Charts, CarpetsHaveTheColoursThatWereChosen) {
    const LegendChoice standard, grey{.ramp = Ramp::grey};
    EXPECT_EQ(carpetColour(0.5, CarpetQuantity::scenario, standard), shadowColour(0.5));
    EXPECT_EQ(carpetColour(0.5, CarpetQuantity::scenario, grey), toColour(rampRgb(Ramp::grey, 0.5)));
    EXPECT_EQ(carpetColour(1, CarpetQuantity::incremental, standard), impactColour(1));
}

TEST(Charts, NothingToShowIsPainted) {
    QImage image(300, 150, QImage::Format_RGB32);
    QPainter painter(&image);
    const Canvas canvas{painter, 1};
    paintTimeline(canvas, QRectF(image.rect()), {});
    paintCarpet(canvas, QRectF(image.rect()), {});
    paintBars(canvas, QRectF(image.rect()), {});
    EXPECT_FALSE(findSampleAt(QRectF(image.rect()), 1, {}, {150, 80}));
    EXPECT_FALSE(findCellAt(QRectF(image.rect()), 1, {}, {150, 80}));
    EXPECT_FALSE(findGroupAt(QRectF(image.rect()), 1, {}, {150, 80}));
}

TEST(Charts, ASampledDayStandsForThoseUpToTheNext) {
    const std::vector days{twoHours({2026y, std::chrono::June, 1d}), twoHours({2026y, std::chrono::June, 8d}),
                           twoHours({2026y, std::chrono::June, 15d})};
    const CarpetChart chart = makeCarpetChart(days, CarpetQuantity::baseline, 10, utc);
    const QRectF area(0, 0, 400, 200), plot = plotIn(area, 1);
    const auto dayAt = [&](double column) {  // of 21: three weeks
        const auto cell =
            findCellAt(area, 1, chart, {plot.left() + plot.width() * column / 21, plot.bottom() - 1});
        return cell ? int(cell->day) : -1;
    };
    EXPECT_EQ(dayAt(0.5), 0);
    EXPECT_EQ(dayAt(6.5), 0);
    EXPECT_EQ(dayAt(7.5), 1);
    EXPECT_EQ(dayAt(20.5), 2);
    EXPECT_EQ(dayAt(-0.5), -1);
    EXPECT_EQ(describeCell(chart, {1, 0}).toStdString(),
              "2026-06-08, 06:00   50.0 % of the place in the baseline's shadow");
}

TEST(Charts, MonthsAreSumsOfTheWeightedDays) {
    PlaceReview place;
    const auto add = [&](std::chrono::month month, double weight, double baseline, double scenario) {
        ReviewRow row{.day = {2026y, month, 1d}, .weight = weight};
        row.baselineM2h = baseline;
        row.scenarioM2h = scenario;
        row.incrementalM2h = scenario - baseline;
        place.rows.push_back(row);
    };
    add(std::chrono::June, 2, 100, 150);
    add(std::chrono::June, 1, 10, 10);
    add(std::chrono::September, 1, 1000, 1000);
    const BarChart chart = makeMonthBars(place, UnitSystem::both);
    ASSERT_EQ(chart.groups.size(), 2U);
    EXPECT_EQ(chart.groups[0].values, (std::vector<double>{210, 310, 100}));
    // 210, 310 and 100 m2 h by 0.09290304: 2,260.4, 3,336.8 and 1,076.4 sq ft h
    EXPECT_EQ(
        describeGroup(chart, 0).toStdString(),
        "Jun   baseline 210 m² h (2,260 sq ft h); scenario 310 m² h (3,337 sq ft h); incremental 100 m² h "
        "(1,076 sq ft h)");
    const QRectF area(0, 0, 400, 200), plot = plotIn(area, 1);
    EXPECT_EQ(findGroupAt(area, 1, chart, {plot.left() + 1, plot.center().y()}), 0U);
    EXPECT_EQ(findGroupAt(area, 1, chart, {plot.right() - 1, plot.center().y()}), 1U);
    EXPECT_FALSE(findGroupAt(area, 1, chart, {plot.right() + 1, plot.center().y()}));
}

}  // namespace
}  // namespace noonmark
