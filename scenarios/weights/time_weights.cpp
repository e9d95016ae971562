#include "scenarios/weights/time_weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr std::array<const char*, 12> monthNames{"January",   "February", "March",    "April",
                                                 "May",       "June",     "July",     "August",
                                                 "September", "October",  "November", "December"};
constexpr std::array<double, 12> paperWeights{-1, -1, -0.5, 0, 0.5, 1, 1, 1, 0.5, 0, -0.5, -1};

bool holdsDate(const WeightedInterval& interval, month_day date) {
    if (interval.first <= interval.last) return interval.first <= date && date <= interval.last;
    return interval.first <= date || date <= interval.last;
}

Result<void> validate(const WeightedInterval& interval) {
    if (!(interval.weight >= -1 && interval.weight <= 1))
        return failure(fmt::format("A weight cannot be {:g}", interval.weight), interval.name,
                       "Give -1 (unwanted shadow) to 1 (wanted shade)");
    if (!interval.first.ok() || !interval.last.ok())
        return failure("A date is not in the calendar", interval.name, "Give a month and a day of it");
    if (interval.from < minutes(0) || interval.to > hours(24) || interval.from >= hours(24) ||
        interval.to < minutes(0) || interval.from == interval.to)
        return failure("The hours are not a valid range", interval.name,
                       "Give two different hours, 0:00 to 24:00; a later one first spans midnight");
    return {};
}

// The hours before and after midnight of one date.
bool holdsTime(const WeightedInterval& interval, minutes time) {
    if (interval.from < interval.to) return interval.from <= time && time < interval.to;
    return interval.from <= time || time < interval.to;
}

// Mean weight of all hours of three months of the northern half's summer or winter; time without a weight
// counts as 0.
double meanWeight(const TimeWeights& weights, sys_days first, sys_days end) {
    double sum = 0;
    for (sys_days day = first; day < end; day += days(1))
        for (hours hour(0); hour < hours(24); ++hour)
            for (const WeightedInterval& interval : weights.intervals)
                if (interval.holds(day, hour)) sum += interval.weight;
    return sum / double((end - first).count() * 24);
}

bool overlap(const WeightedInterval& a, const WeightedInterval& b) {
    const bool dates = holdsDate(a, b.first) || holdsDate(b, a.first);
    return dates && (holdsTime(a, b.from) || holdsTime(b, a.from));
}

}  // namespace

bool WeightedInterval::holds(CivilDate date, std::chrono::minutes timeOfDay) const {
    return holdsDate(*this, date.month() / date.day()) && holdsTime(*this, timeOfDay);
}

std::optional<Warning> findSeasonMismatch(const TimeWeights& weights, double latitudeDeg) {
    constexpr double tropicDeg = 23.44, least = 0.05;
    const auto wantsShade = [](const WeightedInterval& one) { return one.weight > 0; };
    if (std::abs(latitudeDeg) <= tropicDeg || std::ranges::none_of(weights.intervals, wantsShade))
        return std::nullopt;
    const double juneToAugust =
        meanWeight(weights, sys_days(2001y / June / 1), sys_days(2001y / September / 1));
    const double decemberToFebruary =
        meanWeight(weights, sys_days(2001y / December / 1), sys_days(2002y / March / 1));
    const double summerMinusWinter =
        latitudeDeg > 0 ? juneToAugust - decemberToFebruary : decemberToFebruary - juneToAugust;
    if (summerMinusWinter > -least) return std::nullopt;
    return Warning{
        WarningKind::assumed,
        fmt::format("the weights want more shade in {}, the winter of this place, than in its summer",
                    latitudeDeg > 0 ? "December to February" : "June to August"),
        weights.name};
}

TimeWeights makeMonthlyWeights() {
    TimeWeights table{"default", {}};
    for (unsigned i = 0; i < 12; ++i) {
        const month at{i + 1};
        table.intervals.push_back({.name = monthNames[i],
                                   .first = at / 1,
                                   .last = month_day(at, (2000y / at / std::chrono::last).day()),
                                   .weight = paperWeights[i]});
    }
    return table;
}

Result<void> validate(const TimeWeights& weights) {
    if (weights.name.empty()) return failure("The table has no name", "time weights", "Give it a name");
    if (weights.intervals.empty())
        return failure("The table has no intervals", weights.name, "Add months or dates with a weight");
    for (std::size_t i = 0; i < weights.intervals.size(); ++i) {
        if (const auto sound = validate(weights.intervals[i]); !sound) return sound;
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(weights.intervals[j], weights.intervals[i]))
                return failure(fmt::format("'{}' and '{}' overlap", weights.intervals[j].name,
                                           weights.intervals[i].name),
                               weights.name, "Give every time only one weight");
    }
    return {};
}

}  // namespace noonmark
