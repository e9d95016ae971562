#include "core/review/rule/rule_moments.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace noonmark {

namespace {

using std::chrono::month_day;

constexpr double clockRounding = 1e-3;  // minutes

/// Of a rule about a range of days: those on which planners draw, and the days asked for besides.
std::vector<RuleDay> drawnDays(const Rule& rule, const RuleSun& sun, const std::vector<month_day>& more) {
    if (!rule.days.fixed.empty()) return rule.days.fixed;
    std::set<month_day> days(more.begin(), more.end());
    const CivilDate first = sun.sun.days.front().date, last = sun.sun.days.back().date;
    for (const unsigned month : {3U, 6U, 9U, 12U}) {
        const month_day day{std::chrono::month{month}, std::chrono::day{21}};
        const CivilDate date{first.year(), day.month(), day.day()},
            next{first.year() + std::chrono::years{1}, day.month(), day.day()};
        if (rule.days.mirrored || (date >= first && date <= last) || next <= last) days.insert(day);
    }
    if (days.empty()) days.insert({first.month(), first.day()});
    std::vector<RuleDay> drawn;
    for (const month_day day : days) drawn.push_back({.day = day});
    return drawn;
}

/// Full hours of the clock within the day's steps.
std::vector<double> fullHours(const RuleSun& sun, const SunDay& day, int maxHours) {
    if (day.count == 0) return {};
    const auto minuteOf = [&](std::uint32_t step) {
        return sun.clock.minutesOf(day.date, sun.sun.steps[step].at);
    };
    const double begin = minuteOf(day.first), end = minuteOf(day.first + day.count - 1) + sun.sun.stepMinutes;
    const int first = int(std::ceil((begin - clockRounding) / 60)),
              last = int(std::floor((end + clockRounding) / 60));
    const int every = maxHours > 0 ? std::max(1, (last - first) / maxHours + 1) : 1;
    std::vector<double> hours;
    for (int hour = first; hour <= last; ++hour)
        if ((hour - 12) % every == 0) hours.push_back(hour * 60.0);
    if (hours.empty()) hours.push_back(minuteOf(day.first + day.count / 2));
    return hours;
}

std::vector<double> timesOn(const Rule& rule, const RuleSun& sun, const SunDay& day, int maxHours) {
    if (const auto& diagrams = rule.deliverables.diagrams) {
        const auto own = diagrams->byDay.find(month_day{day.date.month(), day.date.day()});
        const auto& times = own == diagrams->byDay.end() ? diagrams->timesMin : own->second;
        if (!times.empty()) return times;
    }
    return fullHours(sun, day, maxHours);
}

std::vector<RuleMoment> listMoments(const Rule& rule, const RuleSun& sun, int maxHours) {
    std::vector<RuleMoment> moments;
    for (const SunDay& day : sun.sun.days)
        for (const double minutes : timesOn(rule, sun, day, maxHours)) {
            RuleMoment& moment = moments.emplace_back(RuleMoment{day.date, minutes, {}, {}});
            moment.sun.at = sun.clock.instantAt(day.date, minutes);
            moment.clock = sun.clock.timeText(day.date, moment.sun.at);
        }
    return moments;
}

}  // namespace

Result<std::vector<RuleMoment>> computeRuleMoments(const Rule& rule, const RuleSite& site,
                                                   const RuleMomentSettings& settings,
                                                   const std::stop_token& stop) {
    const auto all = computeRuleSun(rule, site, stop);
    if (!all) return tl::make_unexpected(all.error());
    Rule drawn = rule;
    drawn.days.fixed = drawnDays(rule, *all, settings.moreDays);
    const auto days = computeRuleSun(drawn, site, stop);
    if (!days) return tl::make_unexpected(days.error());
    std::vector<RuleMoment> moments = listMoments(rule, *days, settings.maxHoursADay);
    std::vector<DayHours> windows;
    for (const RuleMoment& moment : moments) windows.push_back({moment.day, moment.sun.at, 1});
    const StepRule one{1, true, {rule.window.minSunDeg}};
    const auto sun = computeSunSteps(windows, one, site.observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    std::vector<RuleMoment> up;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        if (sun->days[i].count == 0) continue;
        moments[i].sun = sun->steps[sun->days[i].first];
        up.push_back(std::move(moments[i]));
    }
    return up;
}

std::optional<double> planeOf(const Rule& rule) {
    const bool isPlane = rule.receivers.surface == RuleSurface::plane;
    return isPlane ? std::optional(rule.receivers.planeM) : std::nullopt;
}

bool hasIsochrones(const Rule& rule) {
    const auto& diagrams = rule.deliverables.diagrams;
    return diagrams && std::ranges::find(diagrams->views, "isochrones") != diagrams->views.end();
}

std::vector<double> listLimitMinutes(const Rule& rule) {
    std::set<double> limits;
    for (const Criterion& criterion : rule.criteria)
        for (const Limit& limit : criterion.limits)
            if (criterion.measure == Measure::areaOver)
                limits.insert(criterion.spot.minutes);
            else if (criterion.measure == Measure::spotTotal && !limit.ofFormer)
                limits.insert(limit.value);
    return {limits.begin(), limits.end()};
}

std::vector<double> listIsochroneMinutes(const Rule& rule) {
    const std::vector<double> limits = listLimitMinutes(rule);
    std::set<double> levels(limits.begin(), limits.end());
    for (int hour = 1; hour <= 8; ++hour) levels.insert(60.0 * hour);
    return {levels.begin(), levels.end()};
}

}  // namespace noonmark
