#pragma once

#include <cstddef>
#include <optional>

#include "app/report/charts/chart_axes.h"
#include "core/measures/places/place_timeline.h"
#include "core/sun/day_clock.h"

namespace noonmark {

/// Area of a place in shadow over a day: baseline, and on top of it what the scenario adds, and off it what
/// it gives back.
struct TimelineChart {
    struct Sample {
        double minutes = 0;  ///< of the clock, when the step begins
        double baselineM2 = 0, scenarioM2 = 0, incrementalM2 = 0, gainedM2 = 0;
    };
    std::vector<Sample> samples;         ///< in time order; a gap of more than 1.5 steps breaks the areas
    double stepMinutes = 1;              ///< from one sample to the next
    double areaM2 = 0;                   ///< of the place: the top of the axis, unless little is ever shaded
    double fromMin = 360, toMin = 1080;  ///< of the axis
    UnitSystem units = UnitSystem::metric;
};

/// The time from one step of a day to the next, minutes, which thinned timelines have longer than their
/// study; `otherwise` for a day of fewer than two steps.
double stepMinutesOf(const DayTimeline& day, double otherwise);

/// The chart of one day, in the hours of `clock`; the axis covers the day's steps. `stepMinutes`: of the
/// study.
TimelineChart makeTimelineChart(const DayTimeline& day, double stepMinutes, const DayClock& clock,
                                UnitSystem units = UnitSystem::metric);

/// A chart without samples states why.
void paintTimeline(const Canvas& canvas, const QRectF& area, const TimelineChart& chart);

/// The index of the step at this position of the chart; none beside it or between steps.
std::optional<std::size_t> findSampleAt(const QRectF& area, double point, const TimelineChart& chart,
                                        const QPointF& at);
/// "14:05   incremental 1,204 m², 12 %; scenario 3,400 m², 34 %; baseline 2,196 m², 22 %"; with sun gained,
/// if any.
QString describeSample(const TimelineChart& chart, std::size_t sample);
/// "Incremental shadow from 08:51 to 10:14; at most 1,204 m², 12 % of the place, at 09:30": without a stop.
QString describeIncremental(const DayTimeline& day, const DayClock& clock, UnitSystem units);

}  // namespace noonmark
