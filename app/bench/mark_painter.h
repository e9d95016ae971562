#pragma once

#include <QPainter>
#include <QPainterPath>

#include "app/bench/chart_inks.h"

namespace noonmark {

/// The outline of a mark of size `size`, centred on the origin.
QPainterPath markPath(MarkShape shape, double size);

/// Paints a mark: filled, or hollow where its value is estimated. `size` and `line` in painter units.
void paintMark(QPainter& painter, const QPointF& at, const ChartInk& look, bool hollow, double size,
               double line);

}  // namespace noonmark
