#include "app/report/charts/chart_axes.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <limits>
#include "app/report/maps/sheet_text.h"

namespace noonmark {

namespace {

constexpr double tickPt = 7, axisTitlePt = 7, keyPt = 7.5;
constexpr double leftPt = 48, bottomPt = 15, plotTopPt = 16, rightPt = 12;
constexpr double keyBoxPt = 9, keyGapPt = 3;

void paintText(const Canvas& canvas, const QRectF& box, int flags, const QString& text, double points,
               const QColor& colour) {
    canvas.painter.setFont(textFont(canvas, points));
    canvas.painter.setPen(colour);
    canvas.painter.drawText(box, flags | Qt::TextDontClip, text);
}

double widthOf(const Canvas& canvas, const QString& text, double points) {
    return QFontMetricsF(textFont(canvas, points), canvas.painter.device()).horizontalAdvance(text);
}

void paintTicksAcross(const Canvas& canvas, const QRectF& plot, const ChartAxis& axis) {
    const double pt = canvas.point;
    double free = -std::numeric_limits<double>::infinity();  // right of the text before
    for (const Tick& tick : axis.ticks) {
        const double x = xOf(axis, plot, tick.at);
        canvas.painter.setPen(linePen(canvas, canvas.inks.line, 0.5));
        if (tick.line) canvas.painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        const double half = widthOf(canvas, tick.text, tickPt) / 2;
        if (half <= 0 || x - half < free) continue;
        paintText(canvas, {x - half, plot.bottom() + 2 * pt, 2 * half, 10 * pt},
                  Qt::AlignHCenter | Qt::AlignTop, tick.text, tickPt, canvas.inks.quiet);
        free = x + half + 3 * pt;
    }
}

void paintTicksUp(const Canvas& canvas, const QRectF& plot, const ChartAxis& axis) {
    const double pt = canvas.point;
    for (const Tick& tick : axis.ticks) {
        const double y = yOf(axis, plot, tick.at);
        canvas.painter.setPen(linePen(canvas, canvas.inks.line, 0.5));
        if (tick.line) canvas.painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        paintText(canvas, {plot.left() - leftPt * pt, y - 6 * pt, (leftPt - 4) * pt, 12 * pt},
                  Qt::AlignRight | Qt::AlignVCenter, tick.text, tickPt, canvas.inks.quiet);
    }
}

}  // namespace

AreaUnit areaUnitOf(UnitSystem units) {
    if (units == UnitSystem::imperial) return {squareMetresPerSquareFoot, sheetText("sq ft")};
    return {1, QStringLiteral("m²")};
}

double findNiceStep(double span, int maximum) {
    const double minimum = span / maximum;
    const double power = std::pow(10.0, std::floor(std::log10(minimum)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= minimum * (1 - 1e-9)) return power * factor;
    return power * 10;
}

ChartAxis makeAmountAxis(double lowest, double highest, const QString& title) {
    if (!(highest > lowest)) return {0, 1, {{0, QStringLiteral("0")}}, title};
    const double step = findNiceStep(highest - lowest, 4);
    const auto first = int(std::floor(lowest / step + 1e-9)), last = int(std::ceil(highest / step - 1e-9));
    ChartAxis axis{first * step, last * step, {}, title};
    const int decimals = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));
    for (int i = first; i <= last; ++i)
        axis.ticks.push_back({i * step, sheetNumbers(formatNumber(i * step, decimals))});
    return axis;
}

ChartAxis makeHourAxis(double fromMin, double toMin, double widthPt) {
    constexpr double textPt = 34;
    const double hours = std::max(1.0, (toMin - fromMin) / 60);
    double every = 1;
    for (const double one : {1.0, 2.0, 3.0, 6.0})
        if (every = one; hours / one * textPt <= widthPt) break;
    ChartAxis axis{fromMin, std::max(toMin, fromMin + 1)};
    for (double at = std::ceil(fromMin / (60 * every)) * 60 * every; at <= toMin; at += 60 * every)
        axis.ticks.push_back({at, formatClock(at)});
    return axis;
}

QRectF plotIn(const QRectF& area, double point) {
    return area.adjusted(leftPt * point, plotTopPt * point, -rightPt * point, -bottomPt * point);
}

double xOf(const ChartAxis& axis, const QRectF& plot, double value) {
    return plot.left() + plot.width() * (value - axis.from) / (axis.to - axis.from);
}

double yOf(const ChartAxis& axis, const QRectF& plot, double value) {
    return plot.bottom() - plot.height() * (value - axis.from) / (axis.to - axis.from);
}

double valueAt(const ChartAxis& axis, const QRectF& plot, double x) {
    return axis.from + (x - plot.left()) / plot.width() * (axis.to - axis.from);
}

void paintAxes(const Canvas& canvas, const QRectF& plot, const ChartAxis& across, const ChartAxis& up) {
    paintTicksAcross(canvas, plot, across);
    paintTicksUp(canvas, plot, up);
    canvas.painter.setPen(linePen(canvas, canvas.inks.quiet, 0.6));
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.drawRect(plot);
    const double pt = canvas.point;
    paintText(canvas, {plot.left() - leftPt * pt, plot.top() - plotTopPt * pt, (leftPt - 4) * pt, 10 * pt},
              Qt::AlignRight | Qt::AlignVCenter, up.title, axisTitlePt, canvas.inks.quiet);
}

QRectF keyBox(const Canvas& canvas, const QRectF& plot, double fromPt, double widthPt) {
    const double pt = canvas.point;
    return {plot.left() + fromPt * pt, plot.top() - 12.5 * pt, widthPt * pt, 7 * pt};
}

double paintKeyText(const Canvas& canvas, const QRectF& plot, double fromPt, const QString& text,
                    double scale) {
    const double width = widthOf(canvas, text, scale * keyPt);
    const QRectF box = keyBox(canvas, plot, fromPt, width / canvas.point);
    paintText(canvas, box.adjusted(0, -3 * canvas.point, 0, 3 * canvas.point),
              Qt::AlignLeft | Qt::AlignVCenter, text, scale * keyPt, canvas.inks.text);
    return fromPt + width / canvas.point;
}

namespace {

constexpr double apartPt = 12;  // keys from each other

double findKeyScale(const Canvas& canvas, const QRectF& plot, const std::vector<ChartKey>& keys) {
    constexpr double smallest = 0.6;
    double widthPt = -apartPt;
    for (const ChartKey& key : keys)
        if (!key.text.isEmpty())
            widthPt += keyBoxPt + keyGapPt + widthOf(canvas, key.text, keyPt) / canvas.point + apartPt;
    return std::clamp(plot.width() / canvas.point / std::max(widthPt, 1.0), smallest, 1.0);
}

}  // namespace

void paintKeys(const Canvas& canvas, const QRectF& plot, const std::vector<ChartKey>& keys) {
    const double scale = findKeyScale(canvas, plot, keys);
    double at = 0;
    for (const ChartKey& key : keys) {
        if (key.text.isEmpty()) continue;  // the only series of a chart, whose title names it
        const QRectF box = keyBox(canvas, plot, at, scale * keyBoxPt);
        const QColor colour = readableOn(canvas.inks.paper, key.colour);
        if (key.line) {
            canvas.painter.setPen(linePen(canvas, colour, 1.5));
            canvas.painter.drawLine(QPointF(box.left(), box.center().y()),
                                    QPointF(box.right(), box.center().y()));
        } else {
            canvas.painter.fillRect(box, colour);
        }
        at =
            paintKeyText(canvas, plot, at + scale * (keyBoxPt + keyGapPt), key.text, scale) + scale * apartPt;
    }
}

void paintNothing(const Canvas& canvas, const QRectF& area, const QString& words) {
    paintText(canvas, area, Qt::AlignCenter | Qt::TextWordWrap, words, 9, canvas.inks.quiet);
}

QString formatClock(double minutes) {
    const int whole = int(std::lround(minutes));
    return QStringLiteral("%1:%2")
        .arg(whole / 60, 2, 10, QLatin1Char('0'))
        .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace noonmark
