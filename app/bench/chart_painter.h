#pragma once

#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QRectF>
#include <QString>
#include <map>
#include <string>
#include <vector>

#include "app/report/maps/style.h"
#include "core/lab/bench/finding.h"

namespace noonmark {

enum class MarkShape { circle, square, triangle, diamond, pentagon };

/// Colour and mark of a series.
struct ChartInk {
    QColor colour;
    MarkShape shape = MarkShape::circle;
};

/// One colour and shape per value of ChartSeries::colourOf, the same on all pages. The colours are
/// distinguishable for colour-blind readers (Okabe and Ito, 2008, "Color Universal Design", and two of
/// Tol's), the shapes in greyscale print.
class ChartInks {
public:
    explicit ChartInks(const std::vector<bench::Finding>& findings);
    [[nodiscard]] ChartInk of(const std::string& word) const;

private:
    std::map<std::string, ChartInk> inks_;
};

/// Height of a comparison at a font size of `points`, painter units.
double heightOf(const Canvas& canvas, const bench::Comparison& comparison, double points);

/// Paints a table from the top of `area`: header in bold, a hairline below each row, the first column
/// left-aligned, the others right-aligned. Columns are as wide as their content, plus a share of spare width;
/// where width is missing, the first column is cut with an ellipsis.
void paintComparison(const Canvas& canvas, const QRectF& area, const bench::Comparison& comparison,
                     double points);

/// A tick of an axis.
struct AxisTick {
    double place = 0;  ///< position along the axis, as placeOf() returns it
    QString text;      ///< "0.5", "10⁻⁴"
};

/// Maps values to positions along an axis and computes its ticks: round numbers, few enough to fit side by
/// side. Positions on a logarithmic axis are logarithms.
class AxisScale {
public:
    /// The axis covers all `values`; a logarithmic axis ignores values of 0 or less. Without values it covers
    /// a default range around 1.
    AxisScale(const bench::ChartAxis& axis, const std::vector<double>& values);

    [[nodiscard]] double placeOf(double value) const;
    /// Whether the axis can show the value: finite, and above zero on a logarithmic axis.
    [[nodiscard]] bool shows(double value) const;

    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] const std::vector<AxisTick>& ticks() const { return ticks_; }

private:
    void setLinear(double minimum, double maximum);
    void setLogarithmic(double minimum, double maximum);

    bench::ChartAxis axis_;
    double low_ = 0;
    double high_ = 1;
    std::vector<AxisTick> ticks_;
};

/// The outline of a mark of size `size`, centred on the origin.
QPainterPath markPath(MarkShape shape, double size);

/// Paints a mark: filled, or hollow where its value is estimated. `size` and `line` in painter units.
void paintMark(QPainter& painter, const QPointF& at, const ChartInk& look, bool hollow, double size,
               double line);

/// Paints a chart with its title into `area`: axes with round numbers, thin lines, a mark per point, and
/// labels beside points where there is room. Does not paint the legend (bench_pages.cpp). Needs a
/// QApplication.
void paintChart(const Canvas& canvas, const QRectF& area, const bench::Chart& chart, const ChartInks& inks);

}  // namespace noonmark
