#include "app/report/charts/chart_axes.h"

#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr double tickPt = 7, titlePt = 7, keyPt = 7.5;
constexpr double leftPt = 44, bottomPt = 16, topPt = 16, rightPt = 10;

void paintText(const Canvas& canvas, const QRectF& box, int flags, const QString& text, double points,
               const QColor& colour) {
    canvas.painter.setFont(textFont(canvas, points));
    canvas.painter.setPen(colour);
    canvas.painter.drawText(box, flags | Qt::TextDontClip, text);
}

void paintTicksAcross(const Canvas& canvas, const QRectF& plot, const ChartAxis& axis) {
    const double pt = canvas.point;
    for (const Tick& tick : axis.ticks) {
        const double x = xOf(axis, plot, tick.at);
        canvas.painter.setPen(linePen(canvas, ink::line, 0.5));
        canvas.painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        paintText(canvas, {x - 30 * pt, plot.bottom() + 2 * pt, 60 * pt, 10 * pt},
                  Qt::AlignHCenter | Qt::AlignTop, tick.text, tickPt, ink::quiet);
    }
}

void paintTicksUp(const Canvas& canvas, const QRectF& plot, const ChartAxis& axis) {
    const double pt = canvas.point;
    for (const Tick& tick : axis.ticks) {
        const double y = yOf(axis, plot, tick.at);
        canvas.painter.setPen(linePen(canvas, ink::line, 0.5));
        canvas.painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        paintText(canvas, {plot.left() - leftPt * pt, y - 6 * pt, (leftPt - 4) * pt, 12 * pt},
                  Qt::AlignRight | Qt::AlignVCenter, tick.text, tickPt, ink::quiet);
    }
}

}  // namespace

double findNiceStep(double span, int most) {
    const double least = span / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= least * (1 - 1e-9)) return power * factor;
    return power * 10;
}

ChartAxis makeAmountAxis(double highest, const QString& title) {
    ChartAxis axis{0, 1, {}, title};
    if (highest > 0) {
        const double step = findNiceStep(highest, 4);
        axis.to = std::ceil(highest / step - 1e-9) * step;
        for (int i = 0; i * step <= axis.to * (1 + 1e-9); ++i)
            axis.ticks.push_back({i * step, formatAmount(i * step)});
    } else {
        axis.ticks = {{0, QStringLiteral("0")}};
    }
    return axis;
}

ChartAxis makeHourAxis(double fromMin, double toMin, double widthPt) {
    constexpr double textPt = 34;
    const double hours = std::max(1.0, (toMin - fromMin) / 60);
    double every = 1;
    for (const double one : {1.0, 2.0, 3.0, 6.0})
        if (every = one; hours / one * textPt <= widthPt) break;
    ChartAxis axis{fromMin, std::max(toMin, fromMin + 1), {}, {}};
    for (double at = std::ceil(fromMin / (60 * every)) * 60 * every; at <= toMin; at += 60 * every)
        axis.ticks.push_back({at, formatClock(at)});
    return axis;
}

QRectF plotIn(const Canvas& canvas, const QRectF& area) {
    const double pt = canvas.point;
    return area.adjusted(leftPt * pt, topPt * pt, -rightPt * pt, -bottomPt * pt);
}

double xOf(const ChartAxis& axis, const QRectF& plot, double value) {
    return plot.left() + plot.width() * (value - axis.from) / (axis.to - axis.from);
}

double yOf(const ChartAxis& axis, const QRectF& plot, double value) {
    return plot.bottom() - plot.height() * (value - axis.from) / (axis.to - axis.from);
}

void paintAxes(const Canvas& canvas, const QRectF& plot, const ChartAxis& across, const ChartAxis& up) {
    paintTicksAcross(canvas, plot, across);
    paintTicksUp(canvas, plot, up);
    canvas.painter.setPen(linePen(canvas, ink::quiet, 0.7));
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    canvas.painter.drawLine(plot.topLeft(), plot.bottomLeft());
    const double pt = canvas.point;
    paintText(canvas, {plot.left() - leftPt * pt, plot.top() - topPt * pt, (leftPt - 4) * pt, 10 * pt},
              Qt::AlignRight | Qt::AlignVCenter, up.title, titlePt, ink::quiet);
}

void paintKeys(const Canvas& canvas, const QRectF& plot, const std::vector<ChartKey>& keys) {
    const double pt = canvas.point;
    const QFontMetricsF metrics(textFont(canvas, keyPt), canvas.painter.device());
    double x = plot.left() + 4 * pt;
    const double y = plot.top() - 9 * pt;
    for (const ChartKey& key : keys) {
        if (key.line) {
            canvas.painter.setPen(linePen(canvas, key.colour, 1.5));
            canvas.painter.drawLine(QPointF(x, y), QPointF(x + 9 * pt, y));
        } else {
            canvas.painter.fillRect(QRectF(x, y - 3.5 * pt, 9 * pt, 7 * pt), key.colour);
        }
        const double width = metrics.horizontalAdvance(key.text);
        paintText(canvas, {x + 12 * pt, y - 6 * pt, width, 12 * pt}, Qt::AlignLeft | Qt::AlignVCenter,
                  key.text, keyPt, ink::text);
        x += width + 24 * pt;
    }
}

void paintNothing(const Canvas& canvas, const QRectF& area, const QString& words) {
    paintText(canvas, area, Qt::AlignCenter | Qt::TextWordWrap, words, 9, ink::quiet);
}

QString formatAmount(double value) {
    const bool whole = std::abs(value) >= 10 || value == std::floor(value);
    return QLocale(QLocale::English).toString(value, 'f', whole ? 0 : value < 0.1 ? 2 : 1);
}

QString formatClock(double minutes) {
    const int whole = int(std::lround(minutes));
    return QStringLiteral("%1:%2")
        .arg(whole / 60, 2, 10, QLatin1Char('0'))
        .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace noonmark
