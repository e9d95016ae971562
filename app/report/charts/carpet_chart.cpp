#include "app/report/charts/carpet_chart.h"

#include <QImage>
#include <QLocale>
#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report/charts/timeline_chart.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/maps/style.h"

namespace noonmark {

namespace {

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

void fillDay(CarpetChart& chart, std::size_t index, const DayTimeline& day, const DayClock& clock) {
    std::vector<double> sums(chart.rows);
    std::vector<int> counts(chart.rows);
    for (const PlaceStep& step : day.steps) {
        const double row = (clock.minutesOf(day.day, step.at) - chart.fromMin) / chart.rowMin;
        if (row < 0 || row >= double(chart.rows)) continue;
        sums[std::size_t(row)] += shareOf(day, step, chart.quantity);
        ++counts[std::size_t(row)];
    }
    for (std::size_t row = 0; row < chart.rows; ++row)
        if (counts[row] > 0) chart.shares[index * chart.rows + row] = float(sums[row] / counts[row]);
}

int daysBetween(CivilDate from, CivilDate to) {
    return int((std::chrono::sys_days{to} - std::chrono::sys_days{from}).count());
}

/// The columns of a day, counted in days from the first: [first, end).
std::pair<int, int> columnsOf(const CarpetChart& chart, std::size_t day) {
    constexpr int month = 31;
    const int first = daysBetween(chart.days.front(), chart.days[day]);
    if (day + 1 < chart.days.size())
        return {first, first + std::min(month, daysBetween(chart.days[day], chart.days[day + 1]))};
    const int before = day > 0 ? daysBetween(chart.days[day - 1], chart.days[day]) : 1;
    return {first, first + std::clamp(before, 1, month)};
}

int columnCount(const CarpetChart& chart) { return columnsOf(chart, chart.days.size() - 1).second; }

/// A line at the beginning of each month, and its name in the middle of its days.
ChartAxis monthAxis(const CarpetChart& chart) {
    ChartAxis axis{0, double(columnCount(chart))};
    const auto first = std::chrono::sys_days{chart.days.front()};
    for (int from = 0; from < int(axis.to);) {
        const CivilDate day{first + std::chrono::days{from}};
        const std::chrono::sys_days next{day.year() / day.month() / std::chrono::last};
        const int to = std::min(int(axis.to), int((next - first).count()) + 1);
        if (from > 0) axis.ticks.push_back({double(from)});
        const QString name = QString::fromStdString(wordingInUse().month(day.month(), true));
        constexpr int minNamed = 10;
        if (to - from >= std::min(minNamed, int(axis.to)))
            axis.ticks.push_back({(from + to) / 2.0, name, false});
        from = to;
    }
    return axis;
}

struct CarpetAxes {
    QRectF plot;
    ChartAxis across, up;
};

CarpetAxes axesOf(const QRectF& area, double point, const CarpetChart& chart) {
    const QRectF plot = plotIn(area, point);
    ChartAxis up{chart.fromMin, chart.fromMin + std::max(chart.rowMin, chart.rowMin * double(chart.rows))};
    const double every = plot.height() / point > 90 ? 120 : 240;
    for (double at = std::ceil(up.from / every) * every; at <= up.to; at += every)
        up.ticks.push_back({at, formatClock(at)});
    return {plot, monthAxis(chart), up};
}

QImage imageOf(const CarpetChart& chart, const QColor& paper) {
    QImage image(columnCount(chart), int(chart.rows), QImage::Format_RGB32);
    image.fill(paper);
    for (std::size_t day = 0; day < chart.days.size(); ++day) {
        const auto [first, end] = columnsOf(chart, day);
        for (std::size_t row = 0; row < chart.rows; ++row) {
            const float share = chart.shares[day * chart.rows + row];
            const QColor colour =
                std::isnan(share) ? paper : carpetColour(share, chart.quantity, chart.legend);
            for (int x = first; x < end; ++x) image.setPixelColor(x, int(chart.rows - 1 - row), colour);
        }
    }
    // Viewers of PDF blur coarse pictures: whole pixels for each cell keep its edges sharp.
    return image.scaled(image.width() * 4, image.height() * 4);
}

/// Colours from no share to the whole place, and that of no sun.
void paintShares(const Canvas& canvas, const QRectF& plot, const CarpetChart& chart) {
    constexpr int parts = 10;
    constexpr double partPt = 8, gapPt = 3;
    double at = paintKeyText(canvas, plot, 0, QStringLiteral("0 %")) + gapPt;
    for (int i = 0; i < parts; ++i, at += partPt)
        canvas.painter.fillRect(keyBox(canvas, plot, at, partPt),
                                carpetColour(i / double(parts - 1), chart.quantity, chart.legend));
    at = paintKeyText(canvas, plot, at + gapPt, sheetText("100 % of the place")) + 12;
    canvas.painter.setPen(linePen(canvas, canvas.inks.quiet, 0.5));
    canvas.painter.drawRect(keyBox(canvas, plot, at, 9));
    paintKeyText(canvas, plot, at + 9 + gapPt, sheetText("not counted"));
}

}  // namespace

QColor carpetColour(double share, CarpetQuantity quantity, const LegendChoice& legend) {
    if (quantity != CarpetQuantity::incremental)
        return toColour(rampRgb(legend.ramp, legend.reversed ? 1 - share : share));
    if (share <= 0) return {0xee, 0xef, 0xf1};
    const double more = 0.5 + 0.5 * (0.15 + 0.85 * share);  // the half of more shadow
    return toColour(rampRgb(legend.changeRamp, legend.changeReversed ? 1 - more : more));
}

CarpetChart makeCarpetChart(std::span<const DayTimeline> days, CarpetQuantity quantity, double minRowMin,
                            const DayClock& clock) {
    CarpetChart chart{.days = {}, .rowMin = minRowMin, .shares = {}, .quantity = quantity};
    for (const DayTimeline& day : days) chart.rowMin = std::max(chart.rowMin, stepMinutesOf(day, 0));
    const auto [from, to] = hoursOf(days, chart.rowMin, clock);
    chart.fromMin = std::min(from, to);
    chart.rows = std::size_t(std::max(0.0, std::ceil((to - from) / chart.rowMin)));
    for (const DayTimeline& day : days) chart.days.push_back(day.day);
    chart.shares.assign(days.size() * chart.rows, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < days.size(); ++i) fillDay(chart, i, days[i], clock);
    return chart;
}

void paintCarpet(const Canvas& canvas, const QRectF& area, const CarpetChart& chart) {
    canvas.painter.save();
    if (chart.days.empty() || chart.rows == 0) {
        paintNothing(canvas, area, sheetText("The sun is not up in the hours of the rule"));
    } else {
        const CarpetAxes axes = axesOf(area, canvas.point, chart);
        canvas.painter.setRenderHint(QPainter::LosslessImageRendering);
        canvas.painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
        canvas.painter.drawImage(axes.plot, imageOf(chart, canvas.inks.paper));
        paintAxes(canvas, axes.plot, axes.across, axes.up);
        paintShares(canvas, axes.plot, chart);
    }
    canvas.painter.restore();
}

std::optional<CarpetCell> findCellAt(const QRectF& area, double point, const CarpetChart& chart,
                                     const QPointF& at) {
    if (chart.days.empty() || chart.rows == 0) return std::nullopt;
    const CarpetAxes axes = axesOf(area, point, chart);
    if (!axes.plot.contains(at)) return std::nullopt;
    const double column = valueAt(axes.across, axes.plot, at.x());
    const double row = (axes.plot.bottom() - at.y()) / axes.plot.height() * double(chart.rows);
    for (std::size_t day = 0; day < chart.days.size(); ++day)
        if (const auto [first, end] = columnsOf(chart, day); column >= first && column < end)
            return CarpetCell{day, std::min(std::size_t(row), chart.rows - 1)};
    return std::nullopt;
}

QString describeCell(const CarpetChart& chart, const CarpetCell& cell) {
    const float share = chart.shares[cell.day * chart.rows + cell.row];
    const QString when = QStringLiteral("%1, %2").arg(
        isEnglishInUse() ? QString::fromStdString(formatText(chart.days[cell.day]))
                         : QString::fromStdString(wordingInUse().date(chart.days[cell.day])),
        formatClock(chart.fromMin + chart.rowMin * double(cell.row)));
    if (std::isnan(share)) return sheetText("%1   not counted").arg(when);
    const QString shadow = chart.quantity == CarpetQuantity::incremental ? sheetText("incremental shadow")
                           : chart.quantity == CarpetQuantity::scenario  ? sheetText("the scenario's shadow")
                                                                         : sheetText("the baseline's shadow");
    return sheetText("%1   %2 % of the place in %3")
        .arg(when)
        .arg(fixedNumber(100 * double(share), 1))
        .arg(shadow);
}

}  // namespace noonmark
