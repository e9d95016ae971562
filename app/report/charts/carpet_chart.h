#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/report/charts/chart_axes.h"
#include "core/measures/legend_choice.h"
#include "core/measures/places/place_timeline.h"
#include "core/sun/day_clock.h"

namespace noonmark {

/// Which share of a place a carpet shows.
enum class CarpetQuantity { incremental, scenario, baseline };

/// Shaded share of a place by hour (up) and day (across).
struct CarpetChart {
    /// In time order; a day stands for those up to the next, at most for a month.
    std::vector<CivilDate> days;
    double fromMin = 0;  ///< of the lowest row, minutes since midnight of the clock
    double rowMin = 10;  ///< minutes of a row
    std::size_t rows = 0;
    std::vector<float>
        shares;  ///< [day x rows + row], 0 to 1; NaN: the sun is down, or not in the rule's hours
    CarpetQuantity quantity = CarpetQuantity::incremental;
    LegendChoice legend{};  ///< its colours
};

/// The carpet of a period, in the hours of `clock`, with rows of `minRowMin` minutes or of the days' steps
/// if these are longer. Of the steps that begin in a row the mean counts.
CarpetChart makeCarpetChart(std::span<const DayTimeline> days, CarpetQuantity quantity, double minRowMin,
                            const DayClock& clock);

/// A chart without days or rows states that there is nothing.
void paintCarpet(const Canvas& canvas, const QRectF& area, const CarpetChart& chart);

/// The colour of a share, 0 to 1.
QColor carpetColour(double share, CarpetQuantity quantity, const LegendChoice& legend);

/// A day and a row of the carpet.
struct CarpetCell {
    std::size_t day = 0, row = 0;
};
/// None beside the plot, or where no day stands.
std::optional<CarpetCell> findCellAt(const QRectF& area, double point, const CarpetChart& chart,
                                     const QPointF& at);
/// "2026-11-03, 14:10   12.0 % of the place in incremental shadow"
QString describeCell(const CarpetChart& chart, const CarpetCell& cell);

}  // namespace noonmark
