#pragma once

#include <QRectF>

#include "app/report/maps/style.h"
#include "core/bench/finding.h"

namespace noonmark {

/// Height of a comparison at a font size of `points`, painter units.
double heightOf(const Canvas& canvas, const bench::Comparison& comparison, double points);

/// Paints a table from the top of `area`: header in bold, a hairline below each row, the first column
/// left-aligned, the others right-aligned. Columns are as wide as their content, plus a share of spare width;
/// where width is missing, the first column is cut with an ellipsis.
void paintComparison(const Canvas& canvas, const QRectF& area, const bench::Comparison& comparison,
                     double points);

}  // namespace noonmark
