#include "core/review/place_review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/review/review_rows.h"
#include "core/review/rule_names.h"

namespace noonmark {

namespace {

std::string limitText(const Criterion& criterion, const Limit& limit) {
    const std::string value = limit.ofFormer ? fmt::format("{:g} x former", limit.value)
                                             : formatMeasured(criterion.measure, limit.value);
    return fmt::format("{} {}", ruleNameOf(comparisonNames(), limit.comparison), value);
}

std::string limitsText(const Criterion& criterion) {
    std::string text;
    for (const Limit& limit : criterion.limits)
        text += fmt::format("{}{}", text.empty() ? "" : " or ", limitText(criterion, limit));
    return text;
}

/// "At least 2 h of sun ...: 45 % (former 60 %) on 2026-03-21, wanted >= 50 % or >= 0.8 x former".
std::string reasonFor(const Criterion& criterion, const CriterionResult& result) {
    std::string text =
        fmt::format("{}: {}", criterion.name, formatMeasured(criterion.measure, result.value->value));
    if (result.former)
        text += fmt::format(" (former {})", formatMeasured(criterion.measure, result.former->value));
    if (result.day) text += fmt::format(" on {}", formatText(*result.day));
    return text + ", wanted " + limitsText(criterion);
}

bool decides(const Criterion& criterion, const CriterionResult& result) {
    return !criterion.advisory && !criterion.limits.empty() && result.verdict != Verdict::notApplicable;
}

}  // namespace

bool covers(const Rule& rule, PlaceKind kind) {
    return rule.receivers.kinds.empty() ||
           std::ranges::find(rule.receivers.kinds, kind) != rule.receivers.kinds.end();
}

std::string formatMeasured(Measure measure, double value) {
    const std::string_view unit = unitOf(measure);
    if (unit.empty()) return fmt::format("{:.1f} %", value * 100);
    if (unit != "min") return fmt::format("{:.0f} {}", value, unit);
    if (value < 60) return fmt::format("{:.4g} min", value);
    const double minutes = std::round(value * 10) / 10;
    const double hours = std::floor(minutes / 60);
    return minutes == hours * 60 ? fmt::format("{:.0f} h", hours)
                                 : fmt::format("{:.0f} h {:.4g} min", hours, minutes - hours * 60);
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

void PlaceEvaluation::add(const PlaceShadow& shadow, double weight) {
    const DayShadow day(shadow, engineErrorMin_);
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
    totals.sunHours += row.weight * row.windowMin / 60;
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
    const auto end = [&](Verdict verdict, std::string reason) {
        review.verdict = verdict;
        review.reason = std::move(reason);
    };
    // A criterion about nothing that was measured would hold.
    const auto leaveUnjudged = [&](Verdict verdict, std::string reason) {
        for (CriterionResult& result : review.results) result.verdict = verdict;
        end(verdict, std::move(reason));
    };
    if (!covers(*rule_, review.kind))
        return leaveUnjudged(
            Verdict::notApplicable,
            fmt::format("The rule does not cover places of the kind '{}'", nameOf(review.kind)));
    if (rule_->receivers.surface == RuleSurface::windows)
        return leaveUnjudged(Verdict::notChecked, "The rule is about windows, which are not measured");
    if (review.areaM2 <= 0)
        return leaveUnjudged(Verdict::notChecked, "The place has no cell where shadow is measured");
    if (!sunWasUp_) return leaveUnjudged(Verdict::notChecked, "The sun is not up in the rule's hours");
    const Criterion* deciding = nullptr;
    const CriterionResult* result = nullptr;
    for (std::size_t i = 0; i < review.results.size(); ++i) {
        if (!decides(review.criteria[i], review.results[i])) continue;
        if (result && review.results[i].verdict <= result->verdict) continue;
        deciding = &review.criteria[i];
        result = &review.results[i];
    }
    if (!result) return end(Verdict::notApplicable, "The rule states no limit for this place");
    end(result->verdict, reasonFor(*deciding, *result));
}

}  // namespace noonmark
