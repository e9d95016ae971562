#pragma once

#include <QRectF>
#include <span>

#include "app/bench/chart_inks.h"
#include "app/report/sheets/style.h"
#include "core/bench/chart.h"

namespace noonmark {

/// The names of the charts' series, each once, with their marks and lines, in rows from the top of `area`.
/// Painted when `paint`; returns how high it is, painter units, 0 where there is but one name.
double makeLegend(const Canvas& canvas, const QRectF& area, std::span<const bench::Chart> charts,
                  const ChartInks& inks, bool paint);

}  // namespace noonmark
