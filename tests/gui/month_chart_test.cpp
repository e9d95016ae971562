#include "app/gui/docks/results/month_chart.h"

#include <gtest/gtest.h>

#include <QChart>
#include <QChartView>
#include <QCoreApplication>
#include <QGraphicsTextItem>
#include <QLocale>
#include <QTextDocument>
#include <QValueAxis>

namespace noonmark {
namespace {

using namespace std::chrono;

TEST(MonthChart, MonthsWithoutAnyShadowHaveAnAxisFromZeroToOne) {
    MonthChart chart;
    chart.show({{2026y / March, 0, 0, 600}, {2026y / April, 0, 0, 700}});
    const auto views = chart.findChildren<QChartView*>();
    ASSERT_EQ(views.size(), 2);
    for (const QChartView* view : views) {
        const auto axes = view->chart()->axes(Qt::Vertical);
        const auto* amount = qobject_cast<QValueAxis*>(axes.front());
        EXPECT_EQ(amount->min(), 0);
        EXPECT_EQ(amount->max(), 1);
    }
}

TEST(MonthChart, TheAxisHoldsTheLargestMonth) {
    MonthChart chart;
    chart.show({{2026y / March, 1234, 0, 600, -560}, {2026y / April, 10, 0, 700, 5}});
    const auto views = chart.findChildren<QChartView*>();
    ASSERT_EQ(views.size(), 2);
    const auto* area = qobject_cast<QValueAxis*>(views[0]->chart()->axes(Qt::Vertical).front());
    EXPECT_GE(area->max(), 1234);
    const auto* weighted = qobject_cast<QValueAxis*>(views[1]->chart()->axes(Qt::Vertical).front());
    EXPECT_LE(weighted->min(), -560);
}

// The months from October on are longer than January there.
TEST(MonthChart, JapaneseMonthsKeepTheirTens) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Japanese));
    std::vector<MonthFigures> months;
    for (unsigned month = 1; month <= 12; ++month) months.push_back({2026y / month, 10, 5, 700});
    MonthChart chart;
    chart.resize(320, 320);
    chart.show(months);
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
