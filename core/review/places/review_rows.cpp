#include "core/review/places/review_rows.h"

#include <algorithm>
#include <limits>

#include "core/measures/place_timeline.h"

namespace noonmark {

namespace {

std::uint32_t mostOf(const PlaceShadow& spots, std::vector<std::uint32_t> steps) {
    leaveOutBeside(spots, Quantity::shadow, steps);
    return steps.empty() ? 0 : *std::ranges::max_element(steps);
}

/// Raises the most minutes of shadow at one spot to those of these spots.
void takeMostShadow(ReviewRow& row, const PlaceShadow& spots) {
    const double stepMin = spots.stepMinutes;
    const SpotRuns added = countRuns(spots, Quantity::incremental, false);
    row.maxPointMin = std::max(row.maxPointMin, mostOf(spots, added.total) * stepMin);
    row.maxPointRunMin = std::max(row.maxPointRunMin, mostOf(spots, added.longest) * stepMin);
    row.totalMaxPointMin = std::max(row.totalMaxPointMin,
                                    mostOf(spots, countRuns(spots, Quantity::shadow, false).total) * stepMin);
}

/// Steps of sun at the spot with least of it, and of the longest run where that is shortest.
struct LeastSun {
    std::optional<std::uint32_t> total;
    std::uint32_t longest = std::numeric_limits<std::uint32_t>::max();
};

/// Takes the spots with least sun of these if they have less than those so far.
void takeLeastSun(ReviewRow& row, const PlaceShadow& spots, LeastSun& least) {
    SpotRuns sun = countRuns(spots, Quantity::sun, false);
    leaveOutBeside(spots, Quantity::sun, sun.total);
    if (sun.total.empty()) return;
    std::vector<std::uint32_t> longest = sun.longest;
    leaveOutBeside(spots, Quantity::sun, longest);
    const std::uint32_t shortest = *std::ranges::min_element(longest);
    if (shortest < least.longest) {
        least.longest = shortest;
        row.leastLongestSunMin = shortest * spots.stepMinutes;
    }
    const auto spot = std::size_t(std::ranges::min_element(sun.total) - sun.total.begin());
    if (least.total && sun.total[spot] >= *least.total) return;
    least.total = sun.total[spot];
    row.leastSunMin = sun.total[spot] * spots.stepMinutes;
    row.leastSunRunMin = sun.longest[spot] * spots.stepMinutes;
    row.leastSunIntervals = int(sun.count[spot]);
}

/// Enters, exits, intervals, and the largest area.
void addTimes(ReviewRow& row, const DayTimeline& timeline, const DayClock& clock) {
    const ShadowOnPlace& incremental = timeline.incremental;
    row.enters = incremental.enters();
    row.exits = incremental.exits();
    row.intervals = int(incremental.intervals.size());
    row.durationMin = incremental.minutes;
    row.maxAreaM2 = incremental.largestM2;
    row.maxShare = timeline.areaM2 > 0 ? incremental.largestM2 / timeline.areaM2 : 0;
    if (incremental.largestAt) row.maxAtText = clock.timeText(row.day, *incremental.largestAt);
    if (!row.enters) return;
    row.entersText = clock.timeText(row.day, *row.enters);
    row.exitsText = clock.timeText(row.day, *row.exits);
}

void addSpots(ReviewRow& row, const DayShadow& day) {
    LeastSun least;
    takeMostShadow(row, day.shadow());
    takeLeastSun(row, day.shadow(), least);
    for (const PlaceShadow& spots : day.spots()) {
        takeMostShadow(row, spots);
        takeLeastSun(row, spots, least);
    }
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
    // Shadow that stays longest between the centres of cells is on the place as long.
    row.durationMin = std::max(row.durationMin, row.maxPointMin);
    row.totalDurationMin = std::max(timeline.scenario.minutes, row.totalMaxPointMin);
    row.totalMaxAreaM2 = timeline.scenario.largestM2;
    row.hoursMin = timeline.sunlitMinutes;
    return row;
}

}  // namespace noonmark
