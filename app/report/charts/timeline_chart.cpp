#include "app/report/charts/timeline_chart.h"

#include <QObject>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/report/maps/sheet_text.h"
#include "app/report/maps/style.h"

namespace noonmark {

namespace {

using Sample = TimelineChart::Sample;
constexpr double gapFactor = 1.5;  // a longer time between two steps is a gap in the chart

struct TimelineAxes {
    QRectF plot;
    ChartAxis across, up;
    double unitM2;  ///< square metres in the unit of `up`
    [[nodiscard]] QPointF at(double minutes, double m2) const {
        return {xOf(across, plot, minutes), yOf(up, plot, m2 / unitM2)};
    }
};

/// The place's area, so that shares can be seen, unless little of it is ever in shadow.
double topOf(const TimelineChart& chart) {
    constexpr double minShare = 0.2;
    double maximum = 0;
    for (const Sample& sample : chart.samples)
        maximum = std::max({maximum, sample.baselineM2 + sample.incrementalM2, sample.scenarioM2});
    return maximum < minShare * chart.areaM2 ? maximum : std::max(maximum, chart.areaM2);
}

TimelineAxes axesOf(const QRectF& area, double point, const TimelineChart& chart) {
    const QRectF plot = plotIn(area, point);
    const AreaUnit unit = areaUnitOf(chart.units);
    const double topM2 = topOf(chart), top = topM2 / unit.squareMetres;
    ChartAxis up = makeAmountAxis(0, top, unit.name);
    if (topM2 >= chart.areaM2 && topM2 > 0) {  // ends at the whole place
        up.to = top;
        std::erase_if(up.ticks, [&](const Tick& tick) { return tick.at > top; });
    }
    return {plot, makeHourAxis(chart.fromMin, chart.toMin, plot.width() / point), up, unit.squareMetres};
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

/// An area over the steps of each run: it holds from the beginning of a step to the next.
template <class Area>
std::vector<QPolygonF> linesOf(const TimelineAxes& axes, const TimelineChart& chart, const Area& m2) {
    std::vector<QPolygonF> lines;
    for (const auto& [first, last] : runsOf(chart)) {
        QPolygonF& line = lines.emplace_back();
        for (std::size_t i = first; i < last; ++i) {
            const Sample& sample = chart.samples[i];
            const double end =
                i + 1 < last ? chart.samples[i + 1].minutes : sample.minutes + chart.stepMinutes;
            line << axes.at(sample.minutes, m2(sample)) << axes.at(end, m2(sample));
        }
    }
    return lines;
}

template <class Low, class High>
void fillBand(const Canvas& canvas, const TimelineAxes& axes, const TimelineChart& chart, const Low& low,
              const High& high, const QColor& colour) {
    const auto floors = linesOf(axes, chart, low);
    auto bands = linesOf(axes, chart, high);
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(readableOn(canvas.inks.paper, colour));
    for (std::size_t i = 0; i < bands.size(); ++i) {
        for (qsizetype k = floors[i].size(); k-- > 0;) bands[i] << floors[i][k];
        canvas.painter.drawPolygon(bands[i]);
    }
}

void fillBands(const Canvas& canvas, const TimelineAxes& axes, const TimelineChart& chart) {
    const auto none = [](const Sample&) { return 0.0; };
    const auto baseline = [](const Sample& s) { return s.baselineM2; };
    const auto lowered = [](const Sample& s) { return s.baselineM2 - s.gainedM2; };
    const auto raised = [](const Sample& s) { return s.baselineM2 + s.incrementalM2; };
    fillBand(canvas, axes, chart, none, baseline, shade::baseline);
    fillBand(canvas, axes, chart, lowered, baseline, shade::gained);
    fillBand(canvas, axes, chart, baseline, raised, shade::incremental);
}

bool gainsSun(const TimelineChart& chart) {
    return std::ranges::any_of(chart.samples, [](const Sample& sample) { return sample.gainedM2 > 0; });
}

void paintLegend(const Canvas& canvas, const QRectF& plot, const TimelineChart& chart) {
    std::vector<ChartKey> keys{{sheetText("Baseline"), shade::baseline},
                               {sheetText("Scenario"), shade::proposal, true},
                               {sheetText("Incremental"), shade::incremental}};
    if (gainsSun(chart)) keys.push_back({sheetText("Sun gained"), shade::gained});
    paintKeys(canvas, plot, keys);
}

QString areaText(const TimelineChart& chart, double m2) {
    QString text = QString::fromStdString(formatArea(m2, chart.units));
    if (chart.areaM2 > 0)
        text += QStringLiteral(", %1 %").arg(
            fixedNumber(100 * m2 / chart.areaM2, m2 < 0.1 * chart.areaM2 ? 1 : 0));
    return text;
}

}  // namespace

double stepMinutesOf(const DayTimeline& day, double otherwise) {
    double minimum = std::numeric_limits<double>::max();
    for (std::size_t i = 1; i < day.steps.size(); ++i)
        minimum = std::min(minimum, TimeSpan{day.steps[i - 1].at, day.steps[i].at}.minutes());
    return day.steps.size() < 2 ? otherwise : minimum;
}

TimelineChart makeTimelineChart(const DayTimeline& day, double stepMinutes, const DayClock& clock,
                                UnitSystem units) {
    TimelineChart chart{.samples = {}, .stepMinutes = stepMinutesOf(day, stepMinutes), .areaM2 = day.areaM2};
    chart.units = units;
    for (const PlaceStep& step : day.steps)
        chart.samples.push_back({clock.minutesOf(day.day, step.at), step.baselineM2, step.scenarioM2,
                                 step.incrementalM2, step.gainedM2});
    if (chart.samples.empty()) return chart;
    chart.fromMin = std::floor(chart.samples.front().minutes / 60) * 60;
    chart.toMin = std::ceil((chart.samples.back().minutes + chart.stepMinutes) / 60) * 60;
    return chart;
}

void paintTimeline(const Canvas& canvas, const QRectF& area, const TimelineChart& chart) {
    canvas.painter.save();
    if (chart.samples.empty()) {
        paintNothing(canvas, area,
                     sheetText("The sun is not up in the rule's hours, or the place has no open ground"));
    } else {
        canvas.painter.setRenderHint(QPainter::Antialiasing);
        const TimelineAxes axes = axesOf(area, canvas.point, chart);
        fillBands(canvas, axes, chart);
        paintAxes(canvas, axes.plot, axes.across, axes.up);
        canvas.painter.setBrush(Qt::NoBrush);
        canvas.painter.setPen(linePen(canvas, readableOn(canvas.inks.paper, shade::proposal), 1));
        for (const QPolygonF& line : linesOf(axes, chart, [](const Sample& s) { return s.scenarioM2; }))
            canvas.painter.drawPolyline(line);
        paintLegend(canvas, axes.plot, chart);
    }
    canvas.painter.restore();
}

std::optional<std::size_t> findSampleAt(const QRectF& area, double point, const TimelineChart& chart,
                                        const QPointF& at) {
    const TimelineAxes axes = axesOf(area, point, chart);
    if (!axes.plot.contains(at)) return std::nullopt;
    const double minutes = valueAt(axes.across, axes.plot, at.x());
    for (std::size_t i = 0; i < chart.samples.size(); ++i) {
        const double since = minutes - chart.samples[i].minutes;
        if (since >= 0 && since < chart.stepMinutes) return i;
    }
    return std::nullopt;
}

QString describeSample(const TimelineChart& chart, std::size_t sample) {
    const Sample& at = chart.samples[sample];
    QString text = sheetText("%1   incremental %2; scenario %3; baseline %4")
                       .arg(formatClock(at.minutes), areaText(chart, at.incrementalM2),
                            areaText(chart, at.scenarioM2), areaText(chart, at.baselineM2));
    if (at.gainedM2 > 0) text += sheetText("; sun gained %1").arg(areaText(chart, at.gainedM2));
    return text;
}

QString describeIncremental(const DayTimeline& day, const DayClock& clock, UnitSystem units) {
    const ShadowOnPlace& shadow = day.incremental;
    if (!shadow.enters())
        return shadow.largestM2 > 0
                   ? sheetText(
                         "Incremental shadow on the edge of the place alone, beside all centres of cells")
                   : sheetText("No incremental shadow in the rule's hours");
    const auto at = [&](Instant time) { return QString::fromStdString(clock.timeText(day.day, time)); };
    const QString late =
        day.stepMinutes > 1
            ? sheetText(" (up to %1 min too late)").arg(sheetNumbers(formatNumber(day.stepMinutes, 1)))
            : QString();
    return sheetText("Incremental shadow from %1 to %2%6; at most %3, %4 % of the place, at %5")
        .arg(at(*shadow.enters()), at(*shadow.exits()),
             QString::fromStdString(formatArea(shadow.largestM2, units)),
             sheetNumbers(formatNumber(100 * shadow.largestM2 / std::max(1e-9, day.areaM2), 1)),
             at(*shadow.largestAt), late);
}

}  // namespace noonmark
