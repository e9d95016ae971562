#include "app/gui/docks/study_form/rule_period.h"

#include <cmath>

namespace noonmark {

namespace {

using Kind = HoursBound::Kind;

bool isWhole(double minutes) { return minutes == std::floor(minutes); }

bool takesSteps(const Rule& rule) { return rule.sampling.roundTo == 0 && rule.window.minSunDeg == 0; }

std::optional<Period> withHours(const Rule& rule, const HoursOfDay& hours, Period period) {
    if (hours.from.size() != 1 || hours.to.size() != 1) return std::nullopt;
    const HoursBound from = hours.from.front(), to = hours.to.front();
    if (!isWhole(from.minutes) || !isWhole(to.minutes)) return std::nullopt;
    if (from.kind == Kind::clock && to.kind == Kind::clock) {
        if (rule.clock.settings.kind != ClockKind::civil) return std::nullopt;
        period.window.reset();
        period.from = std::chrono::minutes(int(from.minutes));
        period.hours = (to.minutes - from.minutes) / 60;
        return period.hours > 0 ? std::optional(period) : std::nullopt;
    }
    if (from.kind != Kind::sunrise || to.kind != Kind::sunset || from.minutes < 0 || to.minutes > 0)
        return std::nullopt;
    period.window = SolarHours{std::chrono::minutes(int(from.minutes)),
                               std::chrono::minutes(-int(to.minutes)), rule.window.sunrise};
    return period;
}

}  // namespace

std::optional<Period> periodOf(const Rule& rule, std::chrono::month_day day, const Period& period) {
    Period on = period;
    on.start = period.start.year() / day.month() / day.day();
    if (!takesSteps(rule) || !on.start.ok()) return std::nullopt;
    on.days = 1;
    on.stepMinutes = rule.sampling.stepMinutes;
    const auto own = rule.window.byDay.find(day);
    return withHours(rule, own == rule.window.byDay.end() ? rule.window.hours : own->second, on);
}

std::optional<Period> periodOf(const Rule& rule, const Period& period) {
    const RuleDays& days = rule.days;
    if (!days.fixed.empty() || days.everyDays != 1 || days.mirrored || !rule.window.byDay.empty() ||
        !takesSteps(rule))
        return std::nullopt;
    const auto year = period.start.year();
    const CivilDate first = year / days.first.month() / days.first.day();
    const auto lastYear = days.last < days.first ? year + std::chrono::years(1) : year;
    const CivilDate last = lastYear / days.last.month() / days.last.day();
    if (!first.ok() || !last.ok()) return std::nullopt;
    Period over = period;
    over.start = first;
    over.days = int((std::chrono::sys_days(last) - std::chrono::sys_days(first)).count()) + 1;
    over.stepMinutes = rule.sampling.stepMinutes;
    return withHours(rule, rule.window.hours, over);
}

}  // namespace noonmark
