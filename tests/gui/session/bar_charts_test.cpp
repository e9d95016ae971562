#include "app/gui/session/answers/bar_charts.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QChart>
#include <QChartView>
#include <QClipboard>
#include <QCoreApplication>
#include <QGraphicsTextItem>
#include <QGuiApplication>
#include <QLegend>
#include <QLocale>
#include <QTextDocument>
#include <QValueAxis>
#include <cmath>
#include <set>

namespace noonmark {
namespace {

using namespace std::chrono;

Bars barsOf(std::initializer_list<double> values) {
    Bars bars{.title = "Shade"};
    unsigned month = 0;
    for (const double value : values) bars.groups.push_back({2026y / std::chrono::month(++month), {value}});
    return bars;
}

TEST(BarCharts, MonthsWithoutAnyShadowHaveAnAxisFromZeroToOne) {
    BarCharts chart;
    chart.show({barsOf({0, 0}), barsOf({0, 0})});
    const auto views = chart.findChildren<QChartView*>();
    ASSERT_EQ(views.size(), 2);
    for (const QChartView* view : views) {
        const auto axes = view->chart()->axes(Qt::Vertical);
        const auto* amount = qobject_cast<QValueAxis*>(axes.front());
        EXPECT_EQ(amount->min(), 0);
        EXPECT_EQ(amount->max(), 1);
    }
}

TEST(BarCharts, TheAxisHoldsTheLargestMonth) {
    BarCharts chart;
    chart.show({barsOf({1234, 10}), barsOf({-560, 5})});
    const auto views = chart.findChildren<QChartView*>();
    ASSERT_EQ(views.size(), 2);
    const auto* area = qobject_cast<QValueAxis*>(views[0]->chart()->axes(Qt::Vertical).front());
    EXPECT_GE(area->max(), 1234);
    const auto* weighted = qobject_cast<QValueAxis*>(views[1]->chart()->axes(Qt::Vertical).front());
    EXPECT_LE(weighted->min(), -560);
}

TEST(BarCharts, AChartWithoutGroupsIsLeftOut) {
    BarCharts chart;
    chart.show({barsOf({}), barsOf({1})});
    EXPECT_EQ(chart.findChildren<QChartView*>().size(), 1);
    chart.show({});
    EXPECT_TRUE(chart.isHidden());
}

TEST(BarCharts, SeriesSideBySideHaveColoursOfTheirOwnAlsoInTheChartOfTheirChanges) {
    const Bars hours{.title = "Sun",
                     .series = {"Existing", "Low", "Tall", "Wide"},
                     .groups = {{2026y / January, {4, 3, 2, std::nan("")}}}};
    BarCharts chart;
    chart.show({hours, changesOf(hours, "Change")});
    const auto views = chart.findChildren<QChartView*>();
    ASSERT_EQ(views.size(), 2);
    const auto setsOf = [&](int view) {
        return qobject_cast<QBarSeries*>(views[view]->chart()->series().front())->barSets();
    };
    std::set<QRgb> colours;
    for (QBarSet* set : setsOf(0)) colours.insert(set->color().rgb());
    EXPECT_EQ(colours.size(), 4U) << "the third and the fourth had the colour of the second";
    for (int i = 0; i < 3; ++i) EXPECT_EQ(setsOf(1)[i]->color(), setsOf(0)[i + 1]->color()) << i;
    EXPECT_EQ(setsOf(0)[3]->at(0), 0) << "a scenario without a value has no bar";
    EXPECT_TRUE(views[1]->chart()->legend()->isVisible());
}

// Most small places of a map are called by their number, and some alike.
TEST(BarCharts, LongAndEqualNamesLeaveRoomForTheBars) {
    Bars places{.title = "Sun", .groupName = "places", .series = {"Existing", "Low"}};
    for (const char* name : {"Plaza", "Plaza", "greenstreet (OSM way 1175460594) beside the long boulevard"})
        places.groups.push_back({std::string(name), {4, 3}});
    BarCharts chart;
    chart.resize(320, 320);
    chart.show({places});
    static_cast<QWidget&>(chart).show();
    QCoreApplication::processEvents();
    const QChart& drawn = *chart.findChild<QChartView*>()->chart();
    const auto* names = qobject_cast<QBarCategoryAxis*>(drawn.axes(Qt::Horizontal).front());
    EXPECT_EQ(names->count(), 3) << "places of the same name stand side by side";
    EXPECT_GT(drawn.plotArea().height(), 50);
    EXPECT_GT(drawn.plotArea().width(), 150);
}

TEST(BarCharts, TheirValuesCanBeCopied) {
    BarCharts chart;
    chart.show({{.title = "Sun", .series = {"Existing", "Low"}, .groups = {{2026y / January, {4, 3.25}}}}});
    chart.findChild<QChartView*>()->actions().front()->trigger();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("\tExisting\tLow\nJan 2026\t4\t3.25\n"));
}

// The months from October on are longer than January there.
TEST(BarCharts, JapaneseMonthsKeepTheirTens) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Japanese));
    const Bars months = barsOf({10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10});
    BarCharts chart;
    chart.resize(320, 320);
    chart.show({months, months});
    static_cast<QWidget&>(chart).show();
    QCoreApplication::processEvents();
    QLocale::setDefault(before);
    int names = 0;
    for (const QChartView* view : chart.findChildren<QChartView*>())
        for (const QGraphicsItem* item : view->scene()->items()) {
            const auto* name = qgraphicsitem_cast<const QGraphicsTextItem*>(item);
            if (!name || !name->toPlainText().contains(QStringLiteral("2026"))) continue;
            ++names;
            EXPECT_LE(name->sceneBoundingRect().bottom() - name->document()->documentMargin(),
                      view->scene()->sceneRect().bottom())
                << name->toPlainText().toStdString();
        }
    EXPECT_EQ(names, 24);
}

}  // namespace
}  // namespace noonmark
