#pragma once

// The folder app/report/charts paints charts on a Canvas, for the window and for books of sheets alike: the
// timeline of a place over a day (timeline_chart.h), its shaded share by hour and day of the year
// (carpet_chart.h) and bars by month (bar_chart.h). A chart is a value in square metres with the units in
// which it is shown. Painting and reading a position use the same plot: plotIn() of the area and the size of
// a point. chart_axes.h (this file) has the frame, ticks and legend that all charts share.

#include <QRectF>
#include <QString>
#include <vector>

#include "app/report/maps/style.h"
#include "core/base/units.h"

namespace noonmark {

/// A line across the plot at a value, with its text below or beside it.
struct Tick {
    double at = 0;
    QString text{};    ///< empty: a line without text
    bool line = true;  ///< false: text without a line
};

/// The range of values along one side of a plot.
struct ChartAxis {
    double from = 0, to = 1;  ///< from < to
    std::vector<Tick> ticks{};
    QString title{};
};

/// An entry of a legend: a filled square or, if `line`, a line.
struct ChartKey {
    QString text;
    QColor colour;
    bool line = false;
};

/// The one unit of an axis of areas, or of areas x hours.
struct AreaUnit {
    double squareMetres = 1;  ///< in one of it
    QString name;             ///< "m²", "sq ft"
};
/// Square feet for imperial, square metres for metric and for both.
AreaUnit areaUnitOf(UnitSystem units);

/// 1, 2 or 5 times a power of ten, so that at most `maximum` steps cover the span; span > 0.
double findNiceStep(double span, int maximum);

/// From the nice number at or below `lowest` (at most 0) to that at or above `highest` (at least 0), about
/// four ticks with digits grouped; 0 to 1 for nothing.
ChartAxis makeAmountAxis(double lowest, double highest, const QString& title);
/// Hours of a day from `fromMin` to `toMin`, minutes since midnight: "06:00" every one, two, three or six
/// hours, as the width in points allows.
ChartAxis makeHourAxis(double fromMin, double toMin, double widthPt);

/// The part of `area` that is left for the plot beside ticks, titles and a line of legend above it; `point`
/// as in Canvas.
QRectF plotIn(const QRectF& area, double point);

/// Position of a value across or up the plot.
double xOf(const ChartAxis& axis, const QRectF& plot, double value);
double yOf(const ChartAxis& axis, const QRectF& plot, double value);
/// The value at a position across the plot.
double valueAt(const ChartAxis& axis, const QRectF& plot, double x);

/// Frame, grid lines, ticks and titles; paint them after the data. Texts across that would touch the one
/// before are left out.
void paintAxes(const Canvas& canvas, const QRectF& plot, const ChartAxis& across, const ChartAxis& up);
/// The legend, left-aligned above the plot; smaller where it would reach beyond it.
void paintKeys(const Canvas& canvas, const QRectF& plot, const std::vector<ChartKey>& keys);
/// One text of the legend, `fromPt` points to the right of the plot's edge, `scale` times as large as usual.
/// Returns the end of it, points.
double paintKeyText(const Canvas& canvas, const QRectF& plot, double fromPt, const QString& text,
                    double scale = 1);
/// The box of a legend's square, `fromPt` points to the right of the plot's edge.
QRectF keyBox(const Canvas& canvas, const QRectF& plot, double fromPt, double widthPt);
/// Words in the middle of an empty chart.
void paintNothing(const Canvas& canvas, const QRectF& area, const QString& words);

/// "09:05" of minutes since midnight.
QString formatClock(double minutes);

}  // namespace noonmark
