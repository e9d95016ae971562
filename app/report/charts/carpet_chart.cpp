#include "app/report/charts/carpet_chart.h"

#include <QImage>
#include <QLinearGradient>
#include <QLocale>
#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report/maps/palette.h"

namespace noonmark {

namespace {

constexpr QColor nightColour{0xee, 0xef, 0xf1};

double shareOf(const DayTimeline& day, const PlaceStep& step, CarpetQuantity quantity) {
    const double m2 = quantity == CarpetQuantity::incremental ? step.incrementalM2
                      : quantity == CarpetQuantity::scenario  ? step.scenarioM2
                                                              : step.baselineM2;
    return day.areaM2 > 0 ? m2 / day.areaM2 : 0;
}

std::pair<double, double> hoursOf(std::span<const DayTimeline> days, double rowMin, const DayClock& clock) {
    double from = 24 * 60, to = 0;
    for (const DayTimeline& day : days) {
        if (day.steps.empty()) continue;
        from = std::min(from, clock.minutesOf(day.day, day.steps.front().at));
        to = std::max(to, clock.minutesOf(day.day, day.steps.back().at) + rowMin);
    }
    return {std::floor(from / 60) * 60, std::ceil(to / 60) * 60};
}

void fillDay(CarpetChart& chart, std::size_t index, const DayTimeline& day, CarpetQuantity quantity,
             const DayClock& clock) {
    std::vector<double> sums(chart.rows);
    std::vector<int> counts(chart.rows);
    for (const PlaceStep& step : day.steps) {
        const double row = (clock.minutesOf(day.day, step.at) - chart.fromMin) / chart.rowMin;
        if (row < 0 || row >= double(chart.rows)) continue;
        sums[std::size_t(row)] += shareOf(day, step, quantity);
        ++counts[std::size_t(row)];
    }
    for (std::size_t row = 0; row < chart.rows; ++row)
        if (counts[row] > 0) chart.shares[index * chart.rows + row] = float(sums[row] / counts[row]);
}

struct CarpetAxes {
    QRectF plot;
    ChartAxis across, up;
};

ChartAxis monthAxis(const CarpetChart& chart) {
    ChartAxis axis{0, double(std::max<std::size_t>(1, chart.days.size())), {}, {}};
    for (std::size_t i = 0; i < chart.days.size(); ++i) {
        const bool begins = i > 0 && chart.days[i].month() != chart.days[i - 1].month();
        if (!begins && i > 0) continue;
        axis.ticks.push_back(
            {double(i), QLocale(QLocale::English)
                            .monthName(int(unsigned(chart.days[i].month())), QLocale::ShortFormat)});
    }
    return axis;
}

CarpetAxes axesOf(const Canvas& canvas, const QRectF& area, const CarpetChart& chart) {
    const QRectF plot = plotIn(canvas, area);
    ChartAxis up{
        chart.fromMin, chart.fromMin + std::max(chart.rowMin, chart.rowMin * double(chart.rows)), {}, {}};
    const double every = plot.height() / canvas.point > 150 ? 120 : 240;
    for (double at = std::ceil(up.from / every) * every; at <= up.to; at += every)
        up.ticks.push_back({at, formatClock(at)});
    return {plot, monthAxis(chart), up};
}

QImage imageOf(const CarpetChart& chart) {
    QImage image(int(chart.days.size()), int(chart.rows), QImage::Format_RGB32);
    image.fill(nightColour);
    for (std::size_t day = 0; day < chart.days.size(); ++day)
        for (std::size_t row = 0; row < chart.rows; ++row) {
            const float share = chart.shares[day * chart.rows + row];
            if (!std::isnan(share))
                image.setPixelColor(int(day), int(chart.rows - 1 - row), shadowColour(double(share)));
        }
    return image;
}

void paintScale(const Canvas& canvas, const QRectF& plot) {
    const double pt = canvas.point;
    const QRectF bar(plot.left() + 4 * pt, plot.top() - 12 * pt, 80 * pt, 7 * pt);
    QLinearGradient colours(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= 10; ++i) colours.setColorAt(i / 10.0, shadowColour(i / 10.0));
    canvas.painter.fillRect(bar, colours);
    canvas.painter.setPen(ink::text);
    canvas.painter.setFont(textFont(canvas, 7));
    canvas.painter.drawText(QRectF(bar.right() + 4 * pt, bar.top() - 3 * pt, 200 * pt, bar.height() + 6 * pt),
                            Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                            QObject::tr("0 to 100 % of the place in shadow"));
}

}  // namespace

CarpetChart makeCarpetChart(std::span<const DayTimeline> days, CarpetQuantity quantity, double rowMin,
                            const DayClock& clock) {
    CarpetChart chart;
    chart.rowMin = rowMin;
    const auto [from, to] = hoursOf(days, rowMin, clock);
    chart.fromMin = std::min(from, to);
    chart.rows = std::size_t(std::max(0.0, std::ceil((to - from) / rowMin)));
    for (const DayTimeline& day : days) chart.days.push_back(day.day);
    chart.shares.assign(days.size() * chart.rows, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < days.size(); ++i) fillDay(chart, i, days[i], quantity, clock);
    return chart;
}

void paintCarpet(const Canvas& canvas, const QRectF& area, const CarpetChart& chart) {
    if (chart.days.empty() || chart.rows == 0) return;
    canvas.painter.save();
    const CarpetAxes axes = axesOf(canvas, area, chart);
    canvas.painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    canvas.painter.drawImage(axes.plot, imageOf(chart));
    paintAxes(canvas, axes.plot, axes.across, axes.up);
    paintScale(canvas, axes.plot);
    canvas.painter.restore();
}

std::optional<CarpetCell> findCellAt(const Canvas& canvas, const QRectF& area, const CarpetChart& chart,
                                     const QPointF& at) {
    const CarpetAxes axes = axesOf(canvas, area, chart);
    if (chart.days.empty() || chart.rows == 0 || !axes.plot.contains(at)) return std::nullopt;
    const double day = (at.x() - axes.plot.left()) / axes.plot.width() * double(chart.days.size());
    const double row = (axes.plot.bottom() - at.y()) / axes.plot.height() * double(chart.rows);
    return CarpetCell{std::min(std::size_t(day), chart.days.size() - 1),
                      std::min(std::size_t(row), chart.rows - 1)};
}

QString describeCell(const CarpetChart& chart, const CarpetCell& cell) {
    const float share = chart.shares[cell.day * chart.rows + cell.row];
    const QString when =
        QObject::tr("%1, %2").arg(QString::fromStdString(formatText(chart.days[cell.day])),
                                  formatClock(chart.fromMin + chart.rowMin * double(cell.row)));
    if (std::isnan(share)) return QObject::tr("%1   not counted").arg(when);
    return QObject::tr("%1   %2 % of the place in shadow").arg(when).arg(100 * double(share), 0, 'f', 1);
}

}  // namespace noonmark
