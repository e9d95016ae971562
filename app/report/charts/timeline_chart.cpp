#include "app/report/charts/timeline_chart.h"

#include <QObject>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

// Told apart by lightness as well as by hue.
constexpr QColor baselineColour{0xc3, 0xc7, 0xcd};
constexpr QColor scenarioColour{0x3b, 0x2a, 0x6e};
constexpr QColor incrementalColour{0xd5, 0x5e, 0x00};
constexpr double gapFactor = 1.5;  // a longer time between two steps is a gap in the chart

struct TimelineAxes {
    QRectF plot;
    ChartAxis across, up;
};

TimelineAxes axesOf(const Canvas& canvas, const QRectF& area, const TimelineChart& chart) {
    double highest = 0;
    for (const auto& sample : chart.samples)
        highest = std::max({highest, sample.baselineM2, sample.scenarioM2, sample.incrementalM2});
    const QRectF plot = plotIn(canvas, area);
    return {plot, makeHourAxis(chart.fromMin, chart.toMin, plot.width() / canvas.point),
            makeAmountAxis(highest, QStringLiteral("m²"))};
}

// Steps with no gap between them: [first, last).
std::vector<std::pair<std::size_t, std::size_t>> runsOf(const TimelineChart& chart) {
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    for (std::size_t i = 0; i < chart.samples.size(); ++i) {
        const bool follows =
            i > 0 && chart.samples[i].minutes - chart.samples[i - 1].minutes <= gapFactor * chart.stepMinutes;
        if (!follows) runs.emplace_back(i, i);
        runs.back().second = i + 1;
    }
    return runs;
}

/// The outline of one quantity over the steps of a run, from its first to its last moment.
QPolygonF lineOfRun(const TimelineAxes& axes, const TimelineChart& chart,
                    std::pair<std::size_t, std::size_t> run, double TimelineChart::Sample::*value) {
    QPolygonF line;
    for (std::size_t i = run.first; i < run.second; ++i)
        line << QPointF(xOf(axes.across, axes.plot, chart.samples[i].minutes),
                        yOf(axes.up, axes.plot, chart.samples[i].*value));
    const auto& last = chart.samples[run.second - 1];
    line << QPointF(xOf(axes.across, axes.plot, last.minutes + chart.stepMinutes), line.back().y());
    return line;
}

void fill(const Canvas& canvas, const TimelineAxes& axes, QPolygonF line, const QColor& colour) {
    line << QPointF(line.back().x(), axes.plot.bottom()) << QPointF(line.front().x(), axes.plot.bottom());
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(colour);
    canvas.painter.drawPolygon(line);
}

void stroke(const Canvas& canvas, const QPolygonF& line, const QColor& colour, double points) {
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, colour, points));
    canvas.painter.drawPolyline(line);
}

QString shareText(const TimelineChart& chart, double m2) {
    if (chart.areaM2 <= 0) return {};
    return QObject::tr(" (%1 %)").arg(100 * m2 / chart.areaM2, 0, 'f', m2 < 0.1 * chart.areaM2 ? 1 : 0);
}

}  // namespace

TimelineChart makeTimelineChart(const DayTimeline& day, double stepMinutes, const DayClock& clock) {
    TimelineChart chart{{}, stepMinutes, day.areaM2};
    for (const PlaceStep& step : day.steps)
        chart.samples.push_back(
            {clock.minutesOf(day.day, step.at), step.baselineM2, step.scenarioM2, step.incrementalM2});
    if (chart.samples.empty()) return chart;
    chart.fromMin = std::floor(chart.samples.front().minutes / 60) * 60;
    chart.toMin = std::ceil((chart.samples.back().minutes + stepMinutes) / 60) * 60;
    return chart;
}

void paintTimeline(const Canvas& canvas, const QRectF& area, const TimelineChart& chart) {
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    const TimelineAxes axes = axesOf(canvas, area, chart);
    using Sample = TimelineChart::Sample;
    for (const auto& run : runsOf(chart)) {
        fill(canvas, axes, lineOfRun(axes, chart, run, &Sample::baselineM2), baselineColour);
        fill(canvas, axes, lineOfRun(axes, chart, run, &Sample::incrementalM2), incrementalColour);
    }
    paintAxes(canvas, axes.plot, axes.across, axes.up);
    for (const auto& run : runsOf(chart)) {
        stroke(canvas, lineOfRun(axes, chart, run, &Sample::incrementalM2), incrementalColour, 1);
        stroke(canvas, lineOfRun(axes, chart, run, &Sample::scenarioM2), scenarioColour, 1.4);
    }
    paintKeys(canvas, axes.plot,
              {{QObject::tr("Baseline"), baselineColour},
               {QObject::tr("Scenario"), scenarioColour, true},
               {QObject::tr("Incremental"), incrementalColour}});
    canvas.painter.restore();
}

std::optional<std::size_t> findSampleAt(const Canvas& canvas, const QRectF& area, const TimelineChart& chart,
                                        const QPointF& at) {
    const TimelineAxes axes = axesOf(canvas, area, chart);
    if (!axes.plot.contains(at)) return std::nullopt;
    const double minutes = axes.across.from + (at.x() - axes.plot.left()) / axes.plot.width() *
                                                  (axes.across.to - axes.across.from);
    for (std::size_t i = 0; i < chart.samples.size(); ++i) {
        const double since = minutes - chart.samples[i].minutes;
        if (since >= 0 && since < chart.stepMinutes) return i;
    }
    return std::nullopt;
}

QString describeSample(const TimelineChart& chart, std::size_t sample) {
    const auto& at = chart.samples[sample];
    return QObject::tr("%1   incremental %2 m²%3, scenario %4 m²%5, baseline %6 m²%7")
        .arg(formatClock(at.minutes), formatAmount(at.incrementalM2), shareText(chart, at.incrementalM2),
             formatAmount(at.scenarioM2), shareText(chart, at.scenarioM2), formatAmount(at.baselineM2),
             shareText(chart, at.baselineM2));
}

}  // namespace noonmark
