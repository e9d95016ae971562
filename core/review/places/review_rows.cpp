#include "core/review/places/review_rows.h"

#include <algorithm>

#include "core/measures/place_timeline.h"

namespace noonmark {

namespace {

double mostOf(const std::vector<std::uint32_t>& steps, double stepMin) {
    return steps.empty() ? 0 : *std::ranges::max_element(steps) * stepMin;
}

/// Enters, exits, intervals, and the largest area.
void addTimes(ReviewRow& row, const DayTimeline& timeline, const DayClock& clock) {
    const ShadowOnPlace& incremental = timeline.incremental;
    row.enters = incremental.enters();
    row.exits = incremental.exits();
    row.intervals = int(incremental.intervals.size());
    row.durationMin = incremental.minutes;
    if (!row.enters) return;
    row.entersText = clock.timeText(row.day, *row.enters);
    row.exitsText = clock.timeText(row.day, *row.exits);
    row.maxAtText = clock.timeText(row.day, *incremental.largestAt);
    row.maxAreaM2 = incremental.largestM2;
    row.maxShare = incremental.largestM2 / timeline.areaM2;
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

}  // namespace

ReviewRow computeReviewRow(const DayShadow& day, const DayClock& clock) {
    const DayTimeline timeline = computeTimeline(day.shadow(), {.steps = false, .longestStays = false});
    ReviewRow row{.day = day.shadow().day};
    addTimes(row, timeline, clock);
    addSpots(row, day);
    row.baselineM2h = timeline.baseline.areaHoursM2;
    row.scenarioM2h = timeline.scenario.areaHoursM2;
    row.incrementalM2h = timeline.incremental.areaHoursM2;
    row.gainedM2h = timeline.gained.areaHoursM2;
    row.fullCoverMin = timeline.allSunTakenMin;
    row.totalDurationMin = timeline.scenario.minutes;
    row.totalMaxAreaM2 = timeline.scenario.largestM2;
    row.windowMin = timeline.sunlitMinutes;
    return row;
}

}  // namespace noonmark
