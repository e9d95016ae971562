#include "app/window/results/month_chart.h"

#include <gtest/gtest.h>

#include <QChart>
#include <QChartView>
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
    chart.show({{2026y / March, 1234, -560, 600}, {2026y / April, 10, 5, 700}});
    const auto views = chart.findChildren<QChartView*>();
    ASSERT_EQ(views.size(), 2);
    const auto* area = qobject_cast<QValueAxis*>(views[0]->chart()->axes(Qt::Vertical).front());
    EXPECT_GE(area->max(), 1234);
    const auto* score = qobject_cast<QValueAxis*>(views[1]->chart()->axes(Qt::Vertical).front());
    EXPECT_LE(score->min(), -560);
}

}  // namespace
}  // namespace noonmark
