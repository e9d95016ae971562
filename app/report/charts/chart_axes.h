#pragma once

// The folder app/report/charts paints charts on a Canvas, for the window and for sheets alike: the timeline
// of a place over a day (timeline_chart.h), its shaded share by hour and day of the year (carpet_chart.h) and
// bars by month (month_bars.h). chart_axes.h (this file) has the frame, ticks and legend that they share.

#include <QRectF>
#include <QString>
#include <vector>

#include "app/report/sheets/style.h"

namespace noonmark {

/// A mark on an axis at a value, with its text; empty: a line without text.
struct Tick {
    double at = 0;
    QString text;
};

/// The range of values along one side of a plot.
struct ChartAxis {
    double from = 0, to = 1;  ///< from < to
    std::vector<Tick> ticks;
    QString title;
};

/// An entry of a legend: a filled square or, if `line`, a line.
struct ChartKey {
    QString text;
    QColor colour;
    bool line = false;
};

/// 1, 2 or 5 times a power of ten, so that at most `most` steps cover the span; span > 0.
double findNiceStep(double span, int most);

/// From 0 to the nice number at or above `highest`, about four ticks with digits grouped; 0 to 1 for nothing.
ChartAxis makeAmountAxis(double highest, const QString& title);
/// Hours of a day from `fromMin` to `toMin`, minutes since midnight: "06:00" every one, two or three hours,
/// as the width in points allows.
ChartAxis makeHourAxis(double fromMin, double toMin, double widthPt);

/// The part of `area` that is left for the plot beside ticks, titles and a line of legend above it.
QRectF plotIn(const Canvas& canvas, const QRectF& area);

/// Position of a value across or up the plot.
double xOf(const ChartAxis& axis, const QRectF& plot, double value);
double yOf(const ChartAxis& axis, const QRectF& plot, double value);

/// Frame, grid lines, ticks and titles; paint them after the data.
void paintAxes(const Canvas& canvas, const QRectF& plot, const ChartAxis& across, const ChartAxis& up);
/// The legend, left-aligned above the plot.
void paintKeys(const Canvas& canvas, const QRectF& plot, const std::vector<ChartKey>& keys);
/// Words in the middle of an empty chart.
void paintNothing(const Canvas& canvas, const QRectF& area, const QString& words);

/// "12,345", or with decimals below ten.
QString formatAmount(double value);
/// "09:05" of minutes since midnight.
QString formatClock(double minutes);

}  // namespace noonmark
