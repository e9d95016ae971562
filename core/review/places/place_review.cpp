#include "core/review/places/place_review.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>

#include "core/measures/places/place_timeline.h"
#include "core/review/places/verdict_text.h"

namespace noonmark {

namespace {

// Cells with their centre beside the place do not count.
std::uint32_t mostOf(const PlaceShadow& spots, const std::vector<std::uint32_t>& steps) {
    std::uint32_t most = steps.empty() ? 0 : std::ranges::max(steps);
    const auto isMost = [&](const WeightedCell& cell) { return cell.isBeside && steps[cell.bit] == most; };
    if (most == 0 || std::ranges::none_of(spots.uneven, isMost)) return most;
    std::vector<std::uint32_t> left = steps;
    leaveOutBeside(spots, Quantity::shadow, left);
    return std::ranges::max(left);
}

/// Raises the most minutes of shadow at one spot to those of these spots.
void takeMostShadow(ReviewRow& row, RunsOfDay& day) {
    const PlaceShadow& spots = day.shadow();
    const double stepMin = spots.stepMinutes;
    const SpotRuns& added = day.count(Quantity::incremental, false);
    row.maxPointMin = std::max(row.maxPointMin, mostOf(spots, added.total) * stepMin);
    row.maxPointRunMin = std::max(row.maxPointRunMin, mostOf(spots, added.longest) * stepMin);
    row.totalMaxPointMin =
        std::max(row.totalMaxPointMin, mostOf(spots, day.count(Quantity::shadow, false).total) * stepMin);
}

/// Steps of sun at the spot with least of it, and of the longest run where that is shortest.
struct LeastSun {
    std::optional<std::uint32_t> total;
    std::uint32_t longest = std::numeric_limits<std::uint32_t>::max();
};

/// Takes the spots with least sun of these if they have less than those so far.
void takeLeastSun(ReviewRow& row, RunsOfDay& day, LeastSun& minimum) {
    const PlaceShadow& spots = day.shadow();
    const SpotRuns& sun = day.count(Quantity::sun, false);
    if (sun.total.empty()) return;
    std::vector<std::uint32_t> total = sun.total, longest = sun.longest;
    leaveOutBeside(spots, Quantity::sun, total);
    leaveOutBeside(spots, Quantity::sun, longest);
    const std::uint32_t shortest = *std::ranges::min_element(longest);
    if (shortest < minimum.longest) {
        minimum.longest = shortest;
        row.minLongestSunMin = shortest * spots.stepMinutes;
    }
    const auto spot = std::size_t(std::ranges::min_element(total) - total.begin());
    if (minimum.total && total[spot] >= *minimum.total) return;
    minimum.total = total[spot];
    row.minSunMin = total[spot] * spots.stepMinutes;
    row.minSunRunMin = sun.longest[spot] * spots.stepMinutes;
    row.minSunIntervals = int(sun.count[spot]);
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
    LeastSun minimum;
    for (RunsOfDay& spots : day.runs()) {
        takeMostShadow(row, spots);
        takeLeastSun(row, spots, minimum);
    }
}

/// The figures of one day that every rule's table may show; `weight` is 1 and `criteria` empty.
ReviewRow computeReviewRow(const DayShadow& day, const DayClock& clock) {
    const DayTimeline timeline =
        computeTimeline(day.shadow(), {.steps = false, .longestStays = false, .spots = day.spots()});
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
    row.hoursMin = timeline.sunlitMinutes;
    return row;
}

bool decides(const Criterion& criterion, const CriterionResult& result) {
    return !criterion.advisory && !criterion.limits.empty() && result.verdict != Verdict::notApplicable;
}

}  // namespace

bool covers(const Rule& rule, PlaceKind kind) {
    return rule.receivers.kinds.empty() ||
           std::ranges::find(rule.receivers.kinds, kind) != rule.receivers.kinds.end();
}

PlaceEvaluation::PlaceEvaluation(const Rule& rule, const DayClock& clock, std::string name, PlaceKind kind,
                                 double engineErrorMin, LineBelt belt)
    : rule_(&rule), clock_(&clock), engineErrorMin_(engineErrorMin) {
    review_.name = std::move(name);
    review_.kind = kind;
    review_.belt = belt;
    for (const Criterion& criterion : rule.criteria) {
        if (criterion.belt != LineBelt::none && criterion.belt != belt) continue;
        review_.criteria.push_back(criterion);
        days_.emplace_back(criterion, rule.days.combination);
    }
}

void PlaceEvaluation::add(const PlaceShadow& shadow, double weight, std::span<const PlaceShadow> spots) {
    const DayShadow day(shadow, engineErrorMin_, spots);
    review_.areaM2 = shadow.areaM2();
    sunWasUp_ = sunWasUp_ || !shadow.steps.empty();
    ReviewRow row = computeReviewRow(day, *clock_);
    row.weight = weight;
    for (CriterionDays& criterion : days_) row.criteria.push_back(criterion.add(day, weight));
    addTotals(row);
    review_.rows.push_back(std::move(row));
}

void PlaceEvaluation::addTotals(const ReviewRow& row) {
    ReviewTotals& totals = review_.totals;
    totals.days += row.weight;
    totals.daysWithIncremental += row.durationMin > 0 ? row.weight : 0;
    totals.sunHours += row.weight * row.hoursMin / 60;
    totals.baselineM2h += row.weight * row.baselineM2h;
    totals.scenarioM2h += row.weight * row.scenarioM2h;
    totals.incrementalM2h += row.weight * row.incrementalM2h;
    totals.gainedM2h += row.weight * row.gainedM2h;
    totals.incrementalByMonthM2h[unsigned(row.day.month()) - 1] += row.weight * row.incrementalM2h;
    if (row.incrementalM2h <= totals.largestDayM2h) return;
    totals.largestDay = row.day;
    totals.largestDayM2h = row.incrementalM2h;
    totals.largestDayDurationMin = row.durationMin;
}

PlaceReview PlaceEvaluation::finish() const {
    PlaceReview review = review_;
    review.totals.theoreticalM2h = review.areaM2 * rule_->theoreticalHours.value_or(review.totals.sunHours);
    for (const CriterionDays& criterion : days_) review.results.push_back(criterion.result());
    judge(review);
    return review;
}

void PlaceEvaluation::judge(PlaceReview& review) const {
    // A criterion about nothing that was measured would hold.
    const auto markUnjudged = [&](Verdict verdict, std::string reason) {
        for (CriterionResult& result : review.results) result.verdict = verdict;
        review.verdict = verdict;
        review.reasonNotJudged = std::move(reason);
    };
    if (!covers(*rule_, review.kind))
        return markUnjudged(
            Verdict::notApplicable,
            fmt::format("The rule does not cover places of the kind '{}'", nameOf(review.kind)));
    if (rule_->receivers.surface == RuleSurface::windows)
        return markUnjudged(Verdict::notApplicable, NM_TEXT("The rule is about windows, not about places"));
    if (review.areaM2 <= 0)
        return markUnjudged(Verdict::notChecked, NM_TEXT("The place has no cell where shadow is measured"));
    if (!sunWasUp_) return markUnjudged(Verdict::notChecked, std::string(noSunInHours));
    for (std::size_t i = 0; i < review.results.size(); ++i) {
        if (!decides(review.criteria[i], review.results[i])) continue;
        if (review.deciding && review.results[i].verdict <= review.verdict) continue;
        review.deciding = i;
        review.verdict = review.results[i].verdict;
    }
    if (review.deciding) return;
    review.verdict = Verdict::notApplicable;
    review.reasonNotJudged = noLimitForPlace;
}

}  // namespace noonmark
