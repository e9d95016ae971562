#include "scenarios/weights/time_weights.h"

#include <fmt/format.h>

#include <array>

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
    if (interval.from < minutes(0) || interval.to > hours(24) || interval.from >= interval.to)
        return failure("The hours are not a valid range", interval.name,
                       "Give an earlier and a later hour, 0:00 to 24:00");
    return {};
}

bool overlap(const WeightedInterval& a, const WeightedInterval& b) {
    const bool dates = holdsDate(a, b.first) || holdsDate(b, a.first);
    return dates && a.from < b.to && b.from < a.to;
}

}  // namespace

bool WeightedInterval::holds(CivilDate date, std::chrono::minutes timeOfDay) const {
    return holdsDate(*this, date.month() / date.day()) && from <= timeOfDay && timeOfDay < to;
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
