#pragma once

#include <QPainter>
#include <QPainterPath>

#include "app/bench/chart_inks.h"

namespace noonmark {

/// The outline of a mark around the origin, `size` across.
QPainterPath markPath(MarkShape shape, double size);

/// A mark at a point: filled, or hollow where its figure is estimated. `size` and `line` in painter units.
void paintMark(QPainter& painter, const QPointF& at, const ChartInk& look, bool hollow, double size,
               double line);

}  // namespace noonmark
