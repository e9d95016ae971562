#include "app/gui/docks/review/review_cache.h"

#include "core/base/memory_guard.h"
#include "core/engines/auto_engine.h"

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

bool hasFewDays(const Rule& rule) { return !rule.days.fixed.empty(); }

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
    ReviewSettings settings = answer.question.settings;
    settings.refinesSpots = false;  // which changes times by less than the step
    return timelinesOf(answer, review, rule, settings, progress, std::move(stop))
        .map([&](RuleTimelines timelines) {
            return ReviewRange{std::move(timelines.days[indexAmong(timelines, answer, review)]),
                               timelines.clock, timelines.stepMinutes};
        });
}

}  // namespace noonmark
