#pragma once

#include <QRectF>
#include <span>

#include "app/bench/chart_inks.h"
#include "app/report/maps/style.h"
#include "core/bench/chart.h"

namespace noonmark {

/// Lays out the names of the charts' series, each once, with their marks and lines, in rows from the top of
/// `area`. Paints them if `paint`. Returns the height in painter units; 0 where there is only one name.
double makeLegend(const Canvas& canvas, const QRectF& area, std::span<const bench::Chart> charts,
                  const ChartInks& inks, bool paint);

}  // namespace noonmark
