#include "core/review/places/place_review.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/review/places/review_rows.h"
#include "core/review/places/verdict_text.h"

namespace noonmark {

namespace {

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
    const auto leaveUnjudged = [&](Verdict verdict, std::string reason) {
        for (CriterionResult& result : review.results) result.verdict = verdict;
        review.verdict = verdict;
        review.unjudged = std::move(reason);
    };
    if (!covers(*rule_, review.kind))
        return leaveUnjudged(
            Verdict::notApplicable,
            fmt::format("The rule does not cover places of the kind '{}'", nameOf(review.kind)));
    if (rule_->receivers.surface == RuleSurface::windows)
        return leaveUnjudged(Verdict::notApplicable, "The rule is about windows, not about places");
    if (review.areaM2 <= 0)
        return leaveUnjudged(Verdict::notChecked, "The place has no cell where shadow is measured");
    if (!sunWasUp_) return leaveUnjudged(Verdict::notChecked, std::string(noSunInHours));
    for (std::size_t i = 0; i < review.results.size(); ++i) {
        if (!decides(review.criteria[i], review.results[i])) continue;
        if (review.deciding && review.results[i].verdict <= review.verdict) continue;
        review.deciding = i;
        review.verdict = review.results[i].verdict;
    }
    if (review.deciding) return;
    review.verdict = Verdict::notApplicable;
    review.unjudged = noLimitForPlace;
}

}  // namespace noonmark
