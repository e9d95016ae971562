#include "core/review/review_rows.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

double mostOf(const std::vector<std::uint32_t>& steps, double stepMin) {
    return steps.empty() ? 0 : *std::ranges::max_element(steps) * stepMin;
}

Instant endOf(const SunStep& step, double stepMin) {
    return step.at + std::chrono::milliseconds{std::llround(stepMin * 60000)};
}

double minutesWith(const DayShadow& day, Quantity quantity, Measure measure) {
    Criterion criterion;
    criterion.quantity = quantity;
    criterion.measure = measure;
    return measureDay(criterion, day, false).value;
}

/// Enters, exits, intervals, and the largest area.
void addTimes(ReviewRow& row, const DayShadow& day, const DayClock& clock) {
    const auto steps = day.shadow().steps;
    const auto& cells = day.cells().incremental;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (cells[i] == 0) continue;
        if (!row.enters) row.enters = steps[i].at;
        const bool unbroken = i > 0 && cells[i - 1] > 0 && steps[i].slot == steps[i - 1].slot + 1;
        row.intervals += unbroken ? 0 : 1;
        row.exits = endOf(steps[i], day.stepMin());
        row.durationMin += day.stepMin();
        if (cells[i] > cells[largest] || cells[largest] == 0) largest = i;
    }
    if (!row.enters) return;
    row.entersText = clock.timeText(row.day, *row.enters);
    row.exitsText = clock.timeText(row.day, *row.exits);
    row.maxAtText = clock.timeText(row.day, steps[largest].at);
    row.maxAreaM2 = cells[largest] * day.shadow().cellAreaM2;
    row.maxShare = cells[largest] / double(day.shadow().baseline.receivers);
}

void addSpots(ReviewRow& row, const DayShadow& day) {
    const SpotRuns added = countRuns(day.shadow(), Quantity::incremental, false);
    row.maxPointMin = mostOf(added.total, day.stepMin());
    row.maxPointRunMin = mostOf(added.longest, day.stepMin());
    row.totalMaxPointMin = mostOf(countRuns(day.shadow(), Quantity::shadow, false).total, day.stepMin());
    const SpotRuns sun = countRuns(day.shadow(), Quantity::sun, false);
    if (sun.total.empty()) return;
    const auto least = std::size_t(std::ranges::min_element(sun.total) - sun.total.begin());
    row.leastSunMin = sun.total[least] * day.stepMin();
    row.leastSunRunMin = sun.longest[least] * day.stepMin();
    row.leastSunIntervals = int(sun.count[least]);
}

void addAreaHours(ReviewRow& row, const DayShadow& day) {
    const double each = day.shadow().cellAreaM2 * day.stepMin() / 60;
    for (std::size_t i = 0; i < day.shadow().steps.size(); ++i) {
        row.baselineM2h += day.cells().baseline[i] * each;
        row.scenarioM2h += day.cells().scenario[i] * each;
        row.incrementalM2h += day.cells().incremental[i] * each;
    }
    row.gainedM2h = std::max(0.0, row.baselineM2h - (row.scenarioM2h - row.incrementalM2h));
}

}  // namespace

ReviewRow computeReviewRow(const DayShadow& day, const DayClock& clock) {
    ReviewRow row{.day = day.shadow().day};
    addTimes(row, day, clock);
    addSpots(row, day);
    addAreaHours(row, day);
    row.fullCoverMin = minutesWith(day, Quantity::incremental, Measure::fullCover);
    row.totalDurationMin = minutesWith(day, Quantity::shadow, Measure::anywhere);
    row.totalMaxAreaM2 = minutesWith(day, Quantity::shadow, Measure::largestArea);
    row.windowMin = double(day.shadow().steps.size()) * day.stepMin();
    return row;
}

}  // namespace noonmark
