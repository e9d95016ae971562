#include "app/report/charts/bar_chart.h"

#include <QLocale>
#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/maps/sheet_text.h"
#include "app/report/maps/style.h"

namespace noonmark {

namespace {

struct BarAxes {
    QRectF plot;
    ChartAxis across, up;
    double unitM2;  ///< square metres in the unit of `up`
};

BarAxes axesOf(const QRectF& area, double point, const BarChart& chart) {
    const AreaUnit unit = chart.unit.isEmpty() ? areaUnitOf(chart.units) : AreaUnit{1, chart.unit};
    double minimum = 0, maximum = 0;
    for (const auto& group : chart.groups)
        for (const double value : group.values)
            maximum = std::max(maximum, value), minimum = std::min(minimum, value);
    const QString title = unit.name + (chart.isAreaHours ? QStringLiteral(" h") : QString());
    ChartAxis across{0, double(std::max<std::size_t>(1, chart.groups.size()))};
    for (std::size_t i = 0; i < chart.groups.size(); ++i)
        across.ticks.push_back({double(i) + 0.5, chart.groups[i].name, false});
    return {plotIn(area, point), across,
            makeAmountAxis(minimum / unit.squareMetres, maximum / unit.squareMetres, title),
            unit.squareMetres};
}

void paintGroup(const Canvas& canvas, const BarAxes& axes, const BarChart& chart, std::size_t index) {
    constexpr double groupShare = 0.8, barShare = 0.92;
    const auto& values = chart.groups[index].values;
    const double width = groupShare / double(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) continue;
        const double from = double(index) + (1 - groupShare) / 2 + double(i) * width;
        const QPointF top(xOf(axes.across, axes.plot, from),
                          yOf(axes.up, axes.plot, values[i] / axes.unitM2));
        const QPointF foot(xOf(axes.across, axes.plot, from + barShare * width), yOf(axes.up, axes.plot, 0));
        canvas.painter.fillRect(QRectF(top, foot).normalized(),
                                readableOn(canvas.inks.paper, chart.series[i].colour));
    }
}

/// "2026-01" of a month, "2 to 4" of a class; in other languages "Jan 2026".
QString nameOfGroup(const Bars::Group& group) {
    const auto* month = std::get_if<std::chrono::year_month>(&group.name);
    if (isEnglishInUse() || month == nullptr) return QString::fromStdString(groupKey(group));
    return QString::fromStdString(wordingInUse().month(month->month(), true)) +
           QStringLiteral(" %1").arg(int(month->year()));
}

QString shortened(const QString& name, qsizetype letters) {
    return name.size() <= letters ? name : name.left(letters - 1) + QChar(0x2026);
}

}  // namespace

BarChart makeMonthBars(const PlaceReview& place, UnitSystem units) {
    BarChart chart{{{sheetText("Baseline"), shade::baseline},
                    {sheetText("Scenario"), shade::proposal},
                    {sheetText("Incremental"), shade::incremental}},
                   {},
                   true,
                   units};
    std::map<unsigned, std::vector<double>> months;
    for (const ReviewRow& row : place.rows) {
        auto& sums = months[unsigned(row.day.month())];
        sums.resize(chart.series.size());
        sums[0] += row.weight * row.baselineM2h;
        sums[1] += row.weight * row.scenarioM2h;
        sums[2] += row.weight * row.incrementalM2h;
    }
    for (const auto& [month, sums] : months)
        chart.groups.push_back(
            {QString::fromStdString(wordingInUse().month(std::chrono::month(month), true)), sums});
    return chart;
}

BarChart makeBarChart(const Bars& bars, FigureUnit figure, UnitSystem units, const QString& unit) {
    constexpr std::size_t keyLetters = 100;  // of all names together have room in one line
    BarChart chart{{}, {}, figure == FigureUnit::squareMetreHours, units, unit};
    for (std::size_t i = 0; i < bars.series.size(); ++i)
        chart.series.push_back(
            {shortened(QString::fromStdString(bars.series[i]), qsizetype(keyLetters / bars.series.size())),
             seriesColour(i + (bars.isChange ? 1 : 0))});
    for (const Bars::Group& group : bars.groups) chart.groups.push_back({nameOfGroup(group), group.values});
    return chart;
}

void paintBars(const Canvas& canvas, const QRectF& area, const BarChart& chart) {
    canvas.painter.save();
    if (chart.groups.empty()) {
        paintNothing(canvas, area, sheetText("No month has a day that counts"));
    } else {
        const BarAxes axes = axesOf(area, canvas.point, chart);
        for (std::size_t i = 0; i < chart.groups.size(); ++i) paintGroup(canvas, axes, chart, i);
        paintAxes(canvas, axes.plot, axes.across, axes.up);
        std::vector<ChartKey> keys;
        for (const auto& series : chart.series) keys.push_back({series.name, series.colour});
        paintKeys(canvas, axes.plot, keys);
    }
    canvas.painter.restore();
}

std::optional<std::size_t> findGroupAt(const QRectF& area, double point, const BarChart& chart,
                                       const QPointF& at) {
    const BarAxes axes = axesOf(area, point, chart);
    if (chart.groups.empty() || !axes.plot.contains(at)) return std::nullopt;
    return std::min(std::size_t(valueAt(axes.across, axes.plot, at.x())), chart.groups.size() - 1);
}

QString describeGroup(const BarChart& chart, std::size_t group) {
    const auto& [name, values] = chart.groups[group];
    QStringList parts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!chart.unit.isEmpty()) {
            parts << QStringLiteral("%1 %2 %3").arg(chart.series[i].name).arg(values[i]).arg(chart.unit);
            continue;
        }
        const std::string value =
            chart.isAreaHours ? formatAreaHours(values[i], chart.units) : formatArea(values[i], chart.units);
        parts << (isEnglishInUse() ? chart.series[i].name.toLower() : chart.series[i].name) + u' ' +
                     QString::fromStdString(value);
    }
    return name + QStringLiteral("   ") + parts.join(QStringLiteral("; "));
}

}  // namespace noonmark
