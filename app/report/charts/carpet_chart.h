#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/report/charts/chart_axes.h"
#include "core/measures/place_timeline.h"
#include "core/sun/day_clock.h"

namespace noonmark {

/// Which share of a place a carpet shows.
enum class CarpetQuantity { incremental, scenario, baseline };

/// Shaded share of a place by hour (up) and day (across).
struct CarpetChart {
    std::vector<CivilDate> days;  ///< in time order
    double fromMin = 0;           ///< of the lowest row, minutes since midnight of the clock
    double rowMin = 10;           ///< minutes of a row
    std::size_t rows = 0;
    std::vector<float>
        shares;  ///< [day x rows + row], 0 to 1; NaN: the sun is down, or not in the rule's hours
};

/// The carpet of a period, in the hours of `clock`. Of the steps that begin in a row the mean counts.
CarpetChart makeCarpetChart(std::span<const DayTimeline> days, CarpetQuantity quantity, double rowMin,
                            const DayClock& clock);

void paintCarpet(const Canvas& canvas, const QRectF& area, const CarpetChart& chart);

/// A day and a row of the carpet.
struct CarpetCell {
    std::size_t day = 0, row = 0;
};
std::optional<CarpetCell> findCellAt(const Canvas& canvas, const QRectF& area, const CarpetChart& chart,
                                     const QPointF& at);
/// "2026-11-03, 14:10: 12 % of the place"
QString describeCell(const CarpetChart& chart, const CarpetCell& cell);

}  // namespace noonmark
