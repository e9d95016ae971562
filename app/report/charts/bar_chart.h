#pragma once

#include <cstddef>
#include <optional>

#include "app/report/charts/chart_axes.h"
#include "core/describe/answer_page.h"
#include "core/describe/figure.h"
#include "core/review/places/place_review.h"

namespace noonmark {

/// Bars in groups, one bar a series: areas, or areas x hours, by month. Values may be negative; NaN: no bar.
struct BarChart {
    struct Series {
        QString name;
        QColor colour;
    };
    struct Group {
        QString name;
        std::vector<double> values;  ///< m2 or m2 h, as many as series
    };
    std::vector<Series> series;
    std::vector<Group> groups;
    bool isAreaHours = false;  ///< values are m2 h
    UnitSystem units = UnitSystem::metric;
    QString unit{};  ///< of values that are no areas: "h"
};

/// Bars of areas, of areas x hours, or of what `unit` says, as a chart.
BarChart makeBarChart(const Bars& bars, FigureUnit figure, UnitSystem units, const QString& unit = {});

/// Area x hours in shadow of the months in which the review has days: baseline, scenario and incremental.
BarChart makeMonthBars(const PlaceReview& place, UnitSystem units);

/// A chart without groups states that there is nothing.
void paintBars(const Canvas& canvas, const QRectF& area, const BarChart& chart);

/// The group at this position; none beside the plot.
std::optional<std::size_t> findGroupAt(const QRectF& area, double point, const BarChart& chart,
                                       const QPointF& at);
/// "Jun   baseline 1,204 m² h; scenario 3,400 m² h; incremental 2,196 m² h"
QString describeGroup(const BarChart& chart, std::size_t group);

}  // namespace noonmark
