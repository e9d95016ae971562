#pragma once

#include <cstddef>
#include <optional>

#include "app/report/charts/chart_axes.h"
#include "core/measures/place_timeline.h"
#include "core/sun/day_clock.h"

namespace noonmark {

/// Area of a place in shadow over a day: baseline, scenario and incremental.
struct TimelineChart {
    struct Sample {
        double minutes = 0;  ///< of the clock, when the step begins
        double baselineM2 = 0, scenarioM2 = 0, incrementalM2 = 0;
    };
    std::vector<Sample> samples;  ///< in time order
    double stepMinutes = 1;
    double areaM2 = 0;                   ///< of the place
    double fromMin = 360, toMin = 1080;  ///< of the axis
};

/// The chart of one day, in the hours of `clock`; the axis covers the day's steps.
TimelineChart makeTimelineChart(const DayTimeline& day, double stepMinutes, const DayClock& clock);

void paintTimeline(const Canvas& canvas, const QRectF& area, const TimelineChart& chart);

/// The index of the step at this position of the chart; none beside it or between steps.
std::optional<std::size_t> findSampleAt(const Canvas& canvas, const QRectF& area, const TimelineChart& chart,
                                        const QPointF& at);
/// "14:05: incremental 1,204 m² (12 %), scenario 3,400 m², baseline 2,196 m²"
QString describeSample(const TimelineChart& chart, std::size_t sample);

}  // namespace noonmark
