#include "app/gui/docks/results/month_chart.h"

#include <QBarCategoryAxis>
#include <QBarSet>
#include <QChart>
#include <QChartView>
#include <QFontMetrics>
#include <QGraphicsLayout>
#include <QLegend>
#include <QStackedBarSeries>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>

#include "app/gui/base/looks/theme.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/report/maps/palette.h"

namespace noonmark {

namespace {

constexpr int chartHeightPx = 150;
constexpr int letterPx = 10;
constexpr int marginPx = 4;

QFont smallFont(QFont font, bool bold = false) {
    font.setPixelSize(letterPx);
    font.setBold(bold);
    return font;
}

/// One value per month.
struct Bars {
    QString title;
    std::vector<double> values;
    QColor above;  ///< colour of values above 0
    QColor below;
};

QStackedBarSeries* seriesOf(const Bars& bars) {
    auto* series = new QStackedBarSeries;
    for (const bool positive : {true, false}) {
        auto* set = new QBarSet(QString());
        for (const double value : bars.values)
            *set << (positive ? std::max(0.0, value) : std::min(0.0, value));
        set->setColor(positive ? bars.above : bars.below);
        set->setBorderColor(Qt::transparent);
        series->append(set);
    }
    series->setBarWidth(0.8);
    return series;
}

template <class Axis>
Axis* axisOf(const QFont& font) {
    const Inks inks = inksOf(themeInUse());
    auto* axis = new Axis;
    axis->setLabelsFont(smallFont(font));
    axis->setLabelsBrush(inks.quiet);
    axis->setGridLinePen(QPen(inks.line, 0.5));
    axis->setLinePen(QPen(inks.quiet, 0.5));
    return axis;
}

void addAxes(QChart& chart, QStackedBarSeries& series, const QStringList& months, const QFont& font) {
    auto* time = axisOf<QBarCategoryAxis>(font);
    time->append(months);
    time->setLabelsAngle(-90);
    time->setTruncateLabels(false);
    time->setGridLineVisible(false);
    auto* amount = axisOf<QValueAxis>(font);
    amount->setLabelFormat(QStringLiteral("%.0f"));
    chart.addAxis(time, Qt::AlignBottom);
    chart.addAxis(amount, Qt::AlignLeft);
    series.attachAxis(time);
    series.attachAxis(amount);
    if (amount->min() < amount->max())
        amount->applyNiceNumbers();
    else
        amount->setRange(0, 1);  // all months are 0: an empty range would give no tick labels
}

// The axis leaves room for names as long as the first. Those of October to December are longer in some
// languages and lost their tens.
int roomForLongerNames(const QStringList& names, const QFont& font) {
    const QFontMetrics metrics(smallFont(font));
    const auto widthOf = [&](const QString& name) { return metrics.horizontalAdvance(name); };
    const auto [least, most] = std::ranges::minmax(names, {}, widthOf);
    return widthOf(most) - widthOf(least) + marginPx;
}

QChartView* viewOf(const Bars& bars, const QStringList& months, const QFont& font) {
    const Inks inks = inksOf(themeInUse());
    auto* chart = new QChart;
    chart->setAnimationOptions(QChart::NoAnimation);
    chart->legend()->hide();
    chart->setTitle(bars.title);
    chart->setTitleFont(smallFont(font, true));
    chart->setTitleBrush(inks.text);
    chart->setBackgroundBrush(inks.paper);
    chart->setMargins({0, 0, marginPx, roomForLongerNames(months, font)});
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    QStackedBarSeries* series = seriesOf(bars);
    chart->addSeries(series);
    addAxes(*chart, *series, months, font);
    auto* view = new QChartView(chart);  // owns the chart
    view->setRenderHint(QPainter::Antialiasing);
    view->setFixedHeight(chartHeightPx);
    view->setFrameShape(QFrame::NoFrame);
    return view;
}

template <class Value>
std::vector<double> getValues(const std::vector<MonthFigures>& months, Value value) {
    std::vector<double> values;
    for (const MonthFigures& month : months) values.push_back(month.*value);
    return values;
}

}  // namespace

MonthChart::MonthChart(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    hide();
    followTheme(*this, [this] { show(months_); });
}

void MonthChart::show(const std::vector<MonthFigures>& months) {
    months_ = months;
    while (QLayoutItem* item = layout()->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    setVisible(!months.empty());
    if (months.empty()) return;
    QStringList names;
    for (const MonthFigures& month : months) names << describeMonth(month.month);
    const Bars area{tr("Shadow area by month, m²"), getValues(months, &MonthFigures::shadowAreaM2),
                    shadowColour(0.6), shadowColour(0.6)};
    const Bars weighted{tr("Weighted shade by month, m² h"),
                        getValues(months, &MonthFigures::weightedShadeM2h), impactColour(-0.8),
                        impactColour(0.8)};
    for (const Bars& bars : {area, weighted}) layout()->addWidget(viewOf(bars, names, font()));
}

}  // namespace noonmark
