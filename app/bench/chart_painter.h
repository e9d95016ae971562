#pragma once

#include <QRectF>

#include "app/bench/chart_inks.h"
#include "app/report/sheets/style.h"
#include "core/bench/chart.h"

namespace noonmark {

/// Paints a chart with its title into `area`: axes with round numbers, thin lines, a mark for each point,
/// words beside points where there is room. No legend: see chart_legend.h. Needs a QApplication.
void paintChart(const Canvas& canvas, const QRectF& area, const bench::Chart& chart, const ChartInks& inks);

}  // namespace noonmark
