#include "app/gui/docks/review/review_question.h"

#include <algorithm>

#include "core/base/memory_guard.h"
#include "core/base/stopwatch.h"
#include "core/engines/auto_engine.h"
#include "core/measures/place_run.h"
#include "core/review/rule/rule_days.h"

namespace noonmark {

namespace {

constexpr double rangeStepMin = 10;
constexpr int longRangeDays = 120;

std::chrono::month_day monthDayOf(CivilDate day) { return day.month() / day.day(); }

/// The timelines of the parcel or place behind a review, of which a parcel has two.
Result<RuleTimelines> timelinesOf(const ReviewAnswer& answer, std::size_t review, const Rule& rule,
                                  const ReviewSettings& settings, Progress& progress, std::stop_token stop) {
    const ReviewQuestion& question = answer.question;
    return guardMemory({.what = "a timeline"}, [&] {
        return computeRuleTimelines(rule, *question.before, *question.after, {answer.placeOf(review)},
                                    settings, AutoEngine(), progress, std::move(stop));
    });
}

std::size_t indexAmong(const RuleTimelines& timelines, const ReviewAnswer& answer, std::size_t review) {
    const auto found = std::ranges::find(timelines.names, answer.study.places[review].name);
    return found == timelines.names.end() ? 0 : std::size_t(found - timelines.names.begin());
}

int lengthOf(const RuleDays& days) {
    const auto of = [](std::chrono::month_day day) {
        return int(unsigned(day.month())) * 31 + int(unsigned(day.day()));
    };
    const int length = of(days.last) - of(days.first);
    return length >= 0 ? length : length + 372;
}

}  // namespace

bool isSame(const ReviewQuestion& a, const ReviewQuestion& b) {
    return a.rule.key == b.rule.key && a.rule.chosen == b.rule.chosen && a.before == b.before &&
           a.after == b.after && a.places == b.places && a.settings.zone == b.settings.zone &&
           a.settings.year == b.settings.year && a.settings.cellM == b.settings.cellM;
}

const Place& ReviewAnswer::placeOf(std::size_t review) const {
    const std::size_t each = question.rule.receivers.hasLines() ? 2 : 1;
    return question.places[std::min(review / each, question.places.size() - 1)];
}

bool hasFewDays(const Rule& rule) { return !rule.days.fixed.empty(); }

Result<ReviewAnswer> computeReview(const ReviewQuestion& question, Progress& progress, std::stop_token stop) {
    const Stopwatch watch;
    return guardMemory({.what = "a review"},
                       [&] {
                           return runReview(question.rule, *question.before, *question.after, question.places,
                                            question.settings, AutoEngine(), progress, std::move(stop));
                       })
        .map([&](ReviewStudy study) {
            return ReviewAnswer{question, std::move(study), watch.seconds()};
        });
}

Result<std::vector<ScreenedPlace>> screen(const ReviewQuestion& question, Progress& progress,
                                          std::stop_token stop) {
    Rule rule = question.rule;
    if (!hasFewDays(rule)) {
        rule.days.everyDays = std::max(7, rule.days.everyDays);
        rule.sampling.stepMinutes = std::max(rangeStepMin, rule.sampling.stepMinutes);
    }
    const auto sun = computeRuleSun(
        rule, {observerOfPlaces(*question.before), question.settings.zone, question.settings.year}, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->sun.steps.empty())
        return failure("No sun in these hours", rule.name, "Choose another rule or year");
    return screenPlaces(*question.before, *question.after, question.places, sun->sun, {}, AutoEngine(),
                        progress, std::move(stop));
}

Result<ReviewDay> computeReviewDay(const ReviewAnswer& answer, std::size_t review, CivilDate day,
                                   Progress& progress, std::stop_token stop) {
    Rule rule = answer.question.rule;
    rule.days.fixed = {RuleDay{monthDayOf(day), {}, {}, {}}};
    rule.days.year = int(day.year());
    ReviewSettings settings = answer.question.settings;
    settings.year = int(day.year());
    return timelinesOf(answer, review, rule, settings, progress, std::move(stop))
        .map([&](RuleTimelines timelines) {
            auto& days = timelines.days[indexAmong(timelines, answer, review)];
            return ReviewDay{days.empty() ? DayTimeline{} : std::move(days.front()), timelines.clock,
                             timelines.stepMinutes};
        });
}

Result<ReviewRange> computeReviewRange(const ReviewAnswer& answer, std::size_t review, Progress& progress,
                                       std::stop_token stop) {
    Rule rule = answer.question.rule;
    rule.days.mirrored = false;
    if (lengthOf(rule.days) > longRangeDays) rule.days.everyDays = std::max(2, rule.days.everyDays);
    rule.sampling.stepMinutes = std::max(rangeStepMin, rule.sampling.stepMinutes);
    return timelinesOf(answer, review, rule, answer.question.settings, progress, std::move(stop))
        .map([&](RuleTimelines timelines) {
            return ReviewRange{std::move(timelines.days[indexAmong(timelines, answer, review)]),
                               timelines.clock, timelines.stepMinutes};
        });
}

}  // namespace noonmark
