#include "core/review/rule/rule_days.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

using std::chrono::month_day;
using std::chrono::sys_days;
using WeightedDates = std::vector<std::pair<CivilDate, double>>;

CivilDate dateIn(month_day day, int year) { return std::chrono::year(year) / day.month() / day.day(); }

Result<WeightedDates> fixedDates(const RuleDays& days, int year) {
    WeightedDates dates;
    for (const RuleDay& day : days.fixed) {
        const CivilDate date = dateIn(day.day, year);
        if (!date.ok())
            return failure(fmt::format("The year {} has no {}", year, formatText(day.day)), "days",
                           "Choose another year");
        dates.emplace_back(date, 1);
    }
    std::ranges::sort(dates);
    return dates;
}

/// 29 February of a year without one is the last of February.
sys_days dayIn(month_day day, int year) {
    const CivilDate date = dateIn(day, year);
    return date.ok() ? sys_days{date} : sys_days{std::chrono::year(year) / day.month() / std::chrono::last};
}

WeightedDates rangeDates(const RuleDays& days, int year) {
    const sys_days first = dayIn(days.first, year);
    const sys_days last = dayIn(days.last, days.last < days.first ? year + 1 : year);
    WeightedDates dates;
    for (sys_days day = first; day <= last; day += std::chrono::days{days.everyDays}) {
        const auto left = (last - day).count() + 1;
        dates.emplace_back(CivilDate{day}, double(std::min<std::int64_t>(days.everyDays, left)));
    }
    return dates;
}

/// Folds the year at 21 June: a day before it counts for the day as long after it, around the year.
WeightedDates mirroredDates(const WeightedDates& wholeYear, int year) {
    const sys_days solstice{std::chrono::year(year) / std::chrono::June / 21};
    const auto length = std::int64_t(
        (sys_days{std::chrono::year(year + 1) / 1 / 1} - sys_days{std::chrono::year(year) / 1 / 1}).count());
    std::map<std::int64_t, double> weights;
    for (const auto& [date, weight] : wholeYear) {
        const std::int64_t after = ((sys_days{date} - solstice).count() + length) % length;
        weights[std::min(after, length - after)] += weight;
    }
    WeightedDates dates;
    for (const auto& [after, weight] : weights)
        dates.emplace_back(CivilDate{solstice + std::chrono::days{after}}, weight);
    return dates;
}

/// The hours of one day of a rule.
class RuleHours {
public:
    RuleHours(const Rule& rule, const DayClock& clock, const Ephemeris& sun)
        : rule_(rule), clock_(clock), sun_(sun) {}

    [[nodiscard]] DayHours on(CivilDate date) const {
        const HoursOfDay& hours = hoursOn(date);
        const SunEvents events = computeSunEvents(sun_, clock_.instantAt(date, 0), rule_.window.sunrise);
        if (events.kind == DayKind::polarNight) return {date, clock_.instantAt(date, 0), 0};
        Instant from = boundAt(date, events, hours.from.front()),
                to = boundAt(date, events, hours.to.front());
        for (const HoursBound& bound : hours.from) from = std::max(from, boundAt(date, events, bound));
        for (const HoursBound& bound : hours.to) to = std::min(to, boundAt(date, events, bound));
        return rounded(date, from, to);
    }

private:
    [[nodiscard]] const HoursOfDay& hoursOn(CivilDate date) const {
        const auto own = rule_.window.byDay.find(month_day{date.month(), date.day()});
        return own == rule_.window.byDay.end() ? rule_.window.hours : own->second;
    }

    /// Without a sunrise or sunset, as the sun stays up, the day bounds the hours.
    [[nodiscard]] Instant boundAt(CivilDate date, const SunEvents& events, const HoursBound& bound) const {
        if (bound.kind == HoursBound::Kind::clock) return clock_.instantAt(date, bound.minutes);
        const bool rise = bound.kind == HoursBound::Kind::sunrise;
        const std::optional<Instant> event = rise ? events.sunrise : events.sunset;
        if (!event) return clock_.instantAt(date, rise ? 0 : 1440);
        return *event + std::chrono::milliseconds{std::llround(bound.minutes * 60000)};
    }

    /// From the first full hour (or what the rule samples) on, and whole steps of it.
    [[nodiscard]] DayHours rounded(CivilDate date, Instant from, Instant to) const {
        const double minutes = double((to - from).count()) / 60000;
        if (rule_.sampling.roundTo == 0 || minutes <= 0) return {date, from, minutes};
        constexpr double rounding = 1e-3;
        const double unit = rule_.sampling.roundTo, step = rule_.sampling.stepMinutes;
        const double begin = std::ceil(clock_.minutesOf(date, from) / unit - rounding) * unit;
        const double end = clock_.minutesOf(date, to);
        const double steps = std::floor((end - begin) / step + rounding);
        return {date, clock_.instantAt(date, begin), std::max(0.0, steps * step)};
    }

    const Rule& rule_;
    const DayClock& clock_;
    const Ephemeris& sun_;
};

/// Each step counts the mean over the days, a hair beside the rule's step where days have no whole number of
/// them: then 24 steps of 5 min are 119.999 min, which misses a limit of 2 h. They count the rule's minutes.
void countWholeMinutes(SunSteps& sun, double stepMinutes) {
    constexpr double hair = 0.002;
    if (std::abs(sun.stepMinutes - stepMinutes) < hair * stepMinutes) sun.stepMinutes = stepMinutes;
}

/// The seasons of dates, from -1 (all at the December solstice) to 1 (all at the June solstice).
double findSeason(const WeightedDates& dates) {
    double sum = 0, weights = 0;
    for (const auto& [date, weight] : dates) {
        const auto sinceSolstice = std::chrono::sys_days(date) - std::chrono::sys_days(date.year() / 6 / 21);
        sum += weight * std::cos(2 * std::numbers::pi * double(sinceSolstice.count()) / 365.25);
        weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
}

/// Whether a rule that was made for the other half of the earth names days of one season, such as winter.
bool hasOtherSeasons(const Rule& rule, const WeightedDates& dates, double latitudeDeg) {
    constexpr double tropicDeg = 23.44, oneSeason = 0.2;
    if (std::abs(latitudeDeg) <= tropicDeg || (latitudeDeg < 0) == rule.isSouthern) return false;
    return std::abs(findSeason(dates)) > oneSeason ||
           std::ranges::any_of(rule.criteria, [](const Criterion& one) { return one.season.has_value(); });
}

}  // namespace

Result<WeightedDates> datesOf(const RuleDays& days, int year) {
    if (!days.fixed.empty()) return fixedDates(days, year);
    const WeightedDates range = rangeDates(days, year);
    return days.mirrored ? mirroredDates(range, year) : range;
}

Result<RuleSun> computeRuleSun(const Rule& rule, const RuleSite& site, const std::stop_token& stop) {
    const int year = rule.days.year.value_or(site.year);
    const auto zone = Zone::named(site.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto dates = datesOf(rule.days, year);
    if (!dates) return tl::make_unexpected(dates.error());
    const auto edge = [](CivilDate date, int days) { return sys_days{date} + std::chrono::days{days}; };
    auto ephemeris =
        Ephemeris::over(site.observer, edge(dates->front().first, -3), edge(dates->back().first, 5));
    if (!ephemeris) return tl::make_unexpected(ephemeris.error());
    const auto shared = std::make_shared<const Ephemeris>(*std::move(ephemeris));
    DayClock clock(rule.clock.settings, *zone, shared, site.observer.place.lonDeg);
    std::vector<DayHours> windows;
    std::vector<double> weights;
    for (const auto& [date, weight] : *dates) {
        windows.push_back(RuleHours(rule, clock, *shared).on(date));
        weights.push_back(weight);
    }
    const StepRule steps{rule.sampling.stepMinutes, true, {rule.window.minSunDeg}};
    auto sun = computeSunSteps(windows, steps, site.observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    countWholeMinutes(*sun, rule.sampling.stepMinutes);
    RuleSun made{*std::move(sun), std::move(weights), std::move(clock), year};
    if (hasOtherSeasons(rule, *dates, site.observer.place.latDeg))
        made.warnings.push_back(
            {WarningKind::assumed,
             "the rule's days are seasons of the other half of the earth, for which it was made: its "
             "winter is summer here",
             rule.name});
    return made;
}

namespace {

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
