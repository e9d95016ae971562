#pragma once

#include <QRectF>

#include "app/report/sheets/style.h"
#include "core/bench/finding.h"

namespace noonmark {

/// How high a comparison of so many rows is with letters of `points`, painter units.
double heightOf(const Canvas& canvas, const bench::Comparison& comparison, double points);

/// A table from the top of `area`, its header in bold, a hairline below each row: the first column at the
/// left, the others right-aligned. Columns are as wide as they need, and a little more where there is room; a
/// first column without room is cut with an ellipsis.
void paintComparison(const Canvas& canvas, const QRectF& area, const bench::Comparison& comparison,
                     double points);

}  // namespace noonmark
