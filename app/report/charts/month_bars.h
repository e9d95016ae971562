#pragma once

#include <array>

#include "app/report/charts/chart_axes.h"

namespace noonmark {

/// One value for each month.
struct MonthBars {
    std::array<double, 12> values{};  ///< January to December, at least 0
    QString unit;                     ///< "m² h"
    QString text;                     ///< what is shown: "Incremental shadow"
};

void paintMonthBars(const Canvas& canvas, const QRectF& area, const MonthBars& bars);

}  // namespace noonmark
