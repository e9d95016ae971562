#pragma once

#include <QRectF>

#include "app/bench/chart_inks.h"
#include "app/report/maps/style.h"
#include "core/bench/chart.h"

namespace noonmark {

/// Paints a chart with its title into `area`: axes with round numbers, thin lines, a mark per point, and
/// labels beside points where there is room. Does not paint the legend (chart_legend.h). Needs a
/// QApplication.
void paintChart(const Canvas& canvas, const QRectF& area, const bench::Chart& chart, const ChartInks& inks);

}  // namespace noonmark
