#include "scenarios/weights/edit_weights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr int yearDays = 366;  // 29 February is a day of every table
constexpr auto leapYear = 2000y;

int dayOf(month_day date) {
    return int((sys_days(leapYear / date) - sys_days(leapYear / January / 1)).count());
}

month_day dateOf(int day) {
    const year_month_day date = sys_days(leapYear / January / 1) + days(day % yearDays);
    return date.month() / date.day();
}

// Number of days of an interval, which may span New Year.
int lengthOf(const WeightedInterval& interval) {
    const int length = dayOf(interval.last) - dayOf(interval.first) + 1;
    return length > 0 ? length : length + yearDays;
}

std::array<bool, yearDays> heldDays(const TimeWeights& table) {
    std::array<bool, yearDays> held{};
    for (const WeightedInterval& interval : table.intervals)
        for (int i = 0; i < lengthOf(interval); ++i)
            held[std::size_t((dayOf(interval.first) + i) % yearDays)] = true;
    return held;
}

std::string nameOf(const WeightedInterval& interval) {
    const auto text = [](month_day date) {
        return fmt::format("{:02}-{:02}", unsigned(date.month()), unsigned(date.day()));
    };
    return text(interval.first) + " to " + text(interval.last);
}

// The first run of free days at or after `from`, around the year.
std::optional<WeightedInterval> gapAfter(const TimeWeights& table, int from) {
    const auto held = heldDays(table);
    const auto isHeld = [&](int day) { return held[std::size_t(day % yearDays)]; };
    int first = from;
    while (first < from + yearDays && isHeld(first)) ++first;
    if (first == from + yearDays) return std::nullopt;
    int last = first % yearDays;
    while (last + 1 < yearDays && !isHeld(last + 1)) ++last;
    return WeightedInterval{.first = dateOf(first), .last = dateOf(last)};
}

Result<WeightedInterval> laterHalf(WeightedInterval& interval) {
    const int length = lengthOf(interval);
    if (length < 2)
        return failure(
            "There is no room for another interval: every day has one, and this one covers a single day",
            interval.name, "Choose a longer one, or shorten one first");
    WeightedInterval half = interval;
    half.first = dateOf(dayOf(interval.first) + length / 2);
    interval.last = dateOf(dayOf(interval.first) + length / 2 - 1);
    return half;
}

}  // namespace

Result<AddedInterval> addInterval(TimeWeights table, std::size_t after) {
    after = std::min(after, table.intervals.size() - 1);
    WeightedInterval& before = table.intervals[after];
    const auto gap = gapAfter(table, dayOf(before.last) + 1);
    auto added = gap ? Result<WeightedInterval>(*gap) : laterHalf(before);
    if (!added) return tl::make_unexpected(added.error());
    added->name = nameOf(*added);
    table.intervals.insert(table.intervals.begin() + std::ptrdiff_t(after) + 1, *added);
    return AddedInterval{std::move(table), after + 1};
}

Result<TimeWeights> removeInterval(TimeWeights table, std::size_t position) {
    if (position < table.intervals.size())
        table.intervals.erase(table.intervals.begin() + std::ptrdiff_t(position));
    return validate(table).map([&] { return std::move(table); });
}

}  // namespace noonmark
