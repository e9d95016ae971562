#include "core/review/glazing/glazing_review.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/wording.h"

namespace noonmark {

namespace {

constexpr double degree = std::numbers::pi / 180;

PanePoint pointAt(const SkyPoint& middle, const PaneSize& pane, glm::dvec2 place) {
    const PaneAxes axes = findPaneAxes(glm::dvec3(middle.normal));
    const glm::dvec3 position = glm::dvec3(middle.position) + place.x * axes.along + place.y * axes.up;
    return {{glm::vec3(position), middle.normal}, pane.low - place, pane.high - place};
}

}  // namespace

PaneSize sizeOrOpening(const RuleGlazing& rule, PaneSize pane) {
    if (pane.isKnown()) return pane;
    const glm::dvec2 half(rule.opening.widthM / 2, rule.opening.heightM / 2);
    return {-half, half};
}

std::vector<PanePoint> placePanePoints(const RuleGlazing& rule, const SkyPoint& middle, PaneSize pane) {
    pane = sizeOrOpening(rule, pane);
    if (rule.point.place == PanePlace::middle) return {pointAt(middle, pane, (pane.low + pane.high) / 2.0)};
    const double wanted = std::max(rule.point.aboveSillM, rule.point.aboveFloorM - rule.opening.sillM);
    const double up = std::clamp(pane.low.y + wanted, pane.low.y, pane.high.y);
    if (rule.point.place == PanePlace::sillMiddle)
        return {pointAt(middle, pane, {(pane.low.x + pane.high.x) / 2, up})};
    return {pointAt(middle, pane, {pane.low.x, up}), pointAt(middle, pane, {pane.high.x, up})};
}

PaneLimits::PaneLimits(const RuleGlazing& rule, const PanePoint& point, PaneSize pane)
    : normal_(point.point.normal),
      axes_(findPaneAxes(normal_)),
      low_(point.low),
      high_(point.high),
      depthM_(rule.point.insideFace ? rule.opening.wallM : 0) {
    const double widthM = sizeOrOpening(rule, pane).widthM();
    const double ofOpening = rule.sweepOfOpening ? std::atan(rule.opening.wallM / widthM) : 0;
    minSweepSine_ = std::sin(std::max(rule.minSweepDeg * degree, ofOpening));
}

bool PaneLimits::admits(glm::dvec3 sun) const {
    const double towards = glm::dot(sun, normal_);
    if (towards <= 0) return false;
    const double level = std::hypot(normal_.x, normal_.y), sunLevel = std::hypot(sun.x, sun.y);
    if (minSweepSine_ > 0 && level > 1e-3) {
        const double sine = (sun.x * normal_.x + sun.y * normal_.y) / (level * std::max(sunLevel, 1e-12));
        if (sine < minSweepSine_ && sunLevel > 1e-6) return false;
    }
    if (depthM_ <= 0) return true;
    const double along = depthM_ * glm::dot(sun, axes_.along) / towards;
    const double up = depthM_ * glm::dot(sun, axes_.up) / towards;
    return along >= low_.x && along <= high_.x && up >= low_.y && up <= high_.y;
}

namespace {

/// Steps [first, end) of one day.
struct StepRange {
    std::uint32_t first, end;
};

/// Lengths of the times in the sun in a range, in steps.
void findLitRuns(const ShadedSteps& shaded, const SunSteps& sun, StepRange range,
                 std::vector<std::uint32_t>& lengths) {
    lengths.clear();
    std::uint32_t length = 0;
    for (std::uint32_t i = range.first; i < range.end; ++i) {
        const bool isBroken = i > range.first && sun.steps[i].slot != sun.steps[i - 1].slot + 1;
        if (length > 0 && (isBroken || shaded[i] != 0)) lengths.push_back(std::exchange(length, 0));
        length += shaded[i] == 0 ? 1 : 0;
    }
    if (length > 0) lengths.push_back(length);
}

/// The steps of a day that begin within a criterion's own hours.
StepRange clipToHours(const Criterion& criterion, const RuleSun& sun, const SunDay& day) {
    StepRange range{day.first, day.first + day.count};
    if (!criterion.hours) return range;
    const Instant from = sun.clock.instantAt(day.date, criterion.hours->first);
    const Instant to = sun.clock.instantAt(day.date, criterion.hours->second);
    while (range.first < range.end && sun.sun.steps[range.first].at < from) ++range.first;
    while (range.end > range.first && sun.sun.steps[range.end - 1].at >= to) --range.end;
    return range;
}

/// Lengths of the times in the sun of one day, in steps, and what sun through crowns adds to their sum.
struct LitRuns {
    std::vector<std::uint32_t> lengths;
    double moreSteps = 0;  // lit steps count as whole ones in the lengths, shaded ones as none

    void find(const ShadedSteps& shaded, const SunShares& shares, const SunSteps& sun, StepRange range) {
        findLitRuns(shaded, sun, range, lengths);
        moreSteps = 0;
        if (shares.empty()) return;
        for (std::uint32_t i = range.first; i < range.end; ++i)
            moreSteps += double(shares[i]) - (shaded[i] == 0 ? 1 : 0);
    }
};

/// The runs of one day, before and after.
struct DayRuns {
    LitRuns before, after;
    void find(const GlazingSunlight& light, const SunSteps& sun, StepRange range) {
        after.find(light.after, light.shares, sun, range);
        if (light.before) before.find(*light.before, light.formerShares, sun, range);
    }
};

Measured measureRuns(const Criterion& criterion, const std::vector<std::uint32_t>& lengths,
                     const RunError& error) {
    const RunCounts runs = countRuns(criterion, lengths, error.stepMin);
    if (criterion.measure != Measure::share) return measureSpot(criterion, runs, error);
    const auto met = [&](int sign) { return meets(criterion.spot, runs, error, sign) ? 1.0 : 0.0; };
    return {met(0), met(-1), met(1)};
}

/// Sums what a share of the year's probable sunlight is made from.
struct ProbableSun {
    Measured sun;         // minutes, weighted by probability
    double possible = 0;  // of the whole year
    void add(const Criterion& criterion, const LitRuns& runs, const RunError& error, double weight) {
        Criterion total = criterion;
        total.measure = Measure::spotTotal;
        const Measured minutes = measureSpot(total, countRuns(total, runs.lengths, error.stepMin), error);
        const double more = runs.moreSteps * error.stepMin;
        sun.value += weight * std::max(0.0, minutes.value + more);
        sun.low += weight * std::max(0.0, minutes.low + more);
        sun.high += weight * std::max(0.0, minutes.high + more);
    }
    [[nodiscard]] Measured percent() const {
        if (possible <= 0) return {};
        const double by = 100 / possible;
        return {sun.value * by, sun.low * by, std::min(100.0, sun.high * by)};
    }
};

/// One criterion over all days, for the scenario and for the baseline held against itself.
class GlazingCriterion {
public:
    /// `isUnchanged`: the window has the same sun before and after.
    GlazingCriterion(const Rule& rule, const Criterion& criterion, bool isUnchanged)
        : rule_(rule),
          criterion_(criterion),
          isUnchanged_(isUnchanged),
          days_(criterion, rule.days.combination),
          formerDays_(criterion, rule.days.combination) {}

    /// `whole`: the runs of the whole day; taken where the criterion has no hours of its own.
    void add(const RuleSun& sun, std::size_t index, const GlazingSunlight& light, const DayRuns& whole,
             const RunError& error) {
        if (criterion_.measure == Measure::skyComponent) return;
        const SunDay& day = sun.sun.days[index];
        if (criterion_.hours) clipped_.find(light, sun.sun, clipToHours(criterion_, sun, day));
        addRuns(day.date, sun.weights[index], day.count * error.stepMin, criterion_.hours ? clipped_ : whole,
                light.before.has_value(), error);
    }

    [[nodiscard]] CriterionResult result(const GlazingSunlight& light) const {
        if (!isOfYear()) return days_.result();
        CriterionResult result{.value = valueOf(light, false), .days = 1};
        if (light.before) result.former = valueOf(light, true);
        result.verdict = judgeLimits(criterion_, *result.value, result.former, isUnchanged(light));
        return result;
    }
    [[nodiscard]] Verdict formerVerdict(const GlazingSunlight& light) const {
        if (!light.before) return Verdict::notApplicable;
        if (!isOfYear()) return formerDays_.result().verdict;
        const Measured former = valueOf(light, true);
        return judgeLimits(criterion_, former, former, true);
    }

private:
    void addRuns(CivilDate day, double weight, double sunUpMin, const DayRuns& runs, bool hasFormer,
                 const RunError& error) {
        if (criterion_.measure == Measure::probableSun)
            return addProbable(day, weight, sunUpMin, runs, error);
        if (!isInSeason(criterion_, day)) return;
        const Measured value = measureRuns(criterion_, runs.after.lengths, error);
        if (!hasFormer) return days_.add(day, value, std::nullopt, weight);
        const Measured former = measureRuns(criterion_, runs.before.lengths, error);
        days_.add(day, value, former, weight, isUnchanged_);
        formerDays_.add(day, former, former, weight, true);
    }

    [[nodiscard]] bool isOfYear() const {
        return criterion_.measure == Measure::skyComponent || criterion_.measure == Measure::probableSun;
    }

    void addProbable(CivilDate day, double weight, double sunUpMin, const DayRuns& runs,
                     const RunError& error) {
        const double probability = rule_.sunshine ? rule_.sunshine->byMonth[unsigned(day.month()) - 1] : 1;
        probable_.possible += weight * probability * sunUpMin;
        formerProbable_.possible = probable_.possible;
        if (!isInSeason(criterion_, day)) return;
        probable_.add(criterion_, runs.after, error, weight * probability);
        formerProbable_.add(criterion_, runs.before, error, weight * probability);
    }

    [[nodiscard]] Measured valueOf(const GlazingSunlight& light, bool former) const {
        if (criterion_.measure == Measure::probableSun)
            return (former ? formerProbable_ : probable_).percent();
        const double value = former ? light.formerSkyComponentPct : light.skyComponentPct;
        return {value, std::max(0.0, value - skyComponentErrorPct), value + skyComponentErrorPct};
    }

    [[nodiscard]] bool isUnchanged(const GlazingSunlight& light) const {
        if (criterion_.measure != Measure::skyComponent) return isUnchanged_;
        constexpr double rounding = 1e-6;
        return std::abs(light.skyComponentPct - light.formerSkyComponentPct) < rounding;
    }

    const Rule& rule_;
    const Criterion& criterion_;
    bool isUnchanged_;
    CriterionDays days_, formerDays_;
    ProbableSun probable_, formerProbable_;
    DayRuns clipped_;
};

/// Criteria that do not apply to the window are not applicable, whatever was measured.
bool isAbout(const Criterion& criterion, const ReviewedGlazing& window) {
    return !criterion.facing || (window.azimuthDeg && criterion.facing->holds(*window.azimuthDeg));
}

bool canDecide(const Criterion& criterion, Verdict verdict) {
    return !criterion.advisory && !criterion.limits.empty() && verdict != Verdict::notApplicable;
}

/// A verdict and the criterion that decides it.
struct Decision {
    Verdict verdict = Verdict::notApplicable;
    std::optional<std::size_t> deciding;
};

/// The worst of the criteria of that list that are about the window; of all where it is null. None where one
/// of the list could not be judged, as it compares with a baseline that the window does not have.
Decision decideAll(const Rule& rule, const ReviewedGlazing& window, const std::vector<Verdict>& verdicts,
                   const std::vector<std::string>* keys) {
    Decision worst;
    for (std::size_t i = 0; i < rule.criteria.size(); ++i) {
        if (keys && std::ranges::find(*keys, rule.criteria[i].key) == keys->end()) continue;
        if (keys && isAbout(rule.criteria[i], window) && verdicts[i] == Verdict::notApplicable) return {};
        if (!canDecide(rule.criteria[i], verdicts[i])) continue;
        if (worst.deciding && verdicts[i] <= worst.verdict) continue;
        worst = {verdicts[i], i};
    }
    return worst;
}

/// The best of the rule's alternatives.
Decision decide(const Rule& rule, const ReviewedGlazing& window, const std::vector<Verdict>& verdicts) {
    if (rule.alternatives.empty()) return decideAll(rule, window, verdicts, nullptr);
    Decision best;
    for (const auto& keys : rule.alternatives) {
        const Decision one = decideAll(rule, window, verdicts, &keys);
        if (one.deciding && (!best.deciding || one.verdict < best.verdict)) best = one;
    }
    return best;
}

void judge(const Rule& rule, GlazingReview& review) {
    std::vector<Verdict> verdicts;
    for (const CriterionResult& result : review.results) verdicts.push_back(result.verdict);
    const Decision now = decide(rule, review.window, verdicts);
    review.verdict = now.verdict;
    review.deciding = now.deciding;
    review.formerVerdict = decide(rule, review.window, review.formerVerdicts).verdict;
    if (!now.deciding)
        review.reasonNotJudged =
            "The rule has no limit for this window: it faces elsewhere, or has no former sun";
}

/// Nothing is judged where the sun is never up in the rule's hours.
void markUnjudged(GlazingReview& review) {
    for (CriterionResult& result : review.results) result.verdict = Verdict::notChecked;
    for (Verdict& verdict : review.formerVerdicts) verdict = Verdict::notChecked;
    review.verdict = review.formerVerdict = Verdict::notChecked;
    review.reasonNotJudged = noSunInHours;
}

void addBands(const RuleSun& sun, const GlazingSunlight& light, GlazingReview& review) {
    if (review.deciding) review.day = review.results[*review.deciding].day;
    if (!review.day && sun.sun.days.size() == 1) review.day = sun.sun.days.front().date;
    if (!review.day) return;
    const auto found = std::ranges::find(sun.sun.days, *review.day, &SunDay::date);
    const auto day = std::size_t(found - sun.sun.days.begin());
    review.bands = findSunBands(light.after, sun.sun, day);
    if (light.before) review.formerBands = findSunBands(*light.before, sun.sun, day);
}

}  // namespace

GlazingReview reviewGlazing(const Rule& rule, const RuleSun& sun, const ReviewedGlazing& window,
                            const GlazingSunlight& light, double engineErrorMin) {
    GlazingReview review{.window = window};
    const double step = sun.sun.stepMinutes;
    const RunError error{step, step + engineErrorMin};
    std::vector<GlazingCriterion> criteria;
    const bool isUnchanged = light.before && *light.before == light.after;
    for (const Criterion& criterion : rule.criteria) criteria.emplace_back(rule, criterion, isUnchanged);
    DayRuns runs;
    for (std::size_t i = 0; i < sun.sun.days.size(); ++i) {
        const SunDay& day = sun.sun.days[i];
        runs.find(light, sun.sun, {day.first, day.first + day.count});
        for (GlazingCriterion& criterion : criteria) criterion.add(sun, i, light, runs, error);
    }
    for (std::size_t i = 0; i < criteria.size(); ++i) {
        review.results.push_back(criteria[i].result(light));
        review.formerVerdicts.push_back(criteria[i].formerVerdict(light));
        if (isAbout(rule.criteria[i], window)) continue;
        review.results.back().verdict = review.formerVerdicts.back() = Verdict::notApplicable;
    }
    if (sun.sun.steps.empty()) {
        markUnjudged(review);
        return review;
    }
    judge(rule, review);
    addBands(sun, light, review);
    return review;
}

std::string describeReason(const Rule& rule, const GlazingReview& review, WriteDate writeDate) {
    if (!review.deciding) return localText(review.reasonNotJudged);
    return describeResult(rule.criteria[*review.deciding], review.results[*review.deciding],
                          UnitSystem::metric, writeDate);
}

}  // namespace noonmark
