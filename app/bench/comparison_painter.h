#pragma once

#include <QColor>
#include <QRectF>
#include <map>
#include <string>

#include "app/report/maps/style.h"
#include "core/bench/finding.h"

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

}  // namespace noonmark
