#include "scenarios/weights/edit_weights.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "core/describe/text.h"

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr double tropicDeg = 23.44, subtropicsDeg = 40, coldDeg = 55;

// Months of the northern half of the earth, and hours.
struct WeightedSeason {
    const char* name;
    unsigned firstMonth, lastMonth;
    int fromHour, toHour;
    double weight;
};

month monthAt(unsigned northern, double latitudeDeg) {
    return month(latitudeDeg < 0 ? (northern + 5) % 12 + 1 : northern);
}

WeightedInterval seasonInterval(const WeightedSeason& season, double latitudeDeg) {
    const month first = monthAt(season.firstMonth, latitudeDeg),
                last = monthAt(season.lastMonth, latitudeDeg);
    return {.name = season.name,
            .first = first / 1,
            .last = month_day(last, (2000y / last / std::chrono::last).day()),
            .from = hours(season.fromHour),
            .to = hours(season.toHour),
            .weight = season.weight};
}

TimeWeights makeSeasons(const char* name, const std::vector<WeightedSeason>& seasons, double latitudeDeg) {
    TimeWeights table{name, {}};
    for (const WeightedSeason& season : seasons)
        table.intervals.push_back(seasonInterval(season, latitudeDeg));
    return table;
}

std::vector<WeightedSeason> comfortSeasons(double fromEquatorDeg) {
    if (fromEquatorDeg < tropicDeg) return {{NM_TEXT("hot all year"), 1, 12, 10, 17, 1}};
    if (fromEquatorDeg < subtropicsDeg)
        return {{NM_TEXT("hot months"), 6, 8, 10, 18, 1},
                {NM_TEXT("before the hot months"), 4, 5, 11, 17, 0.5},
                {NM_TEXT("after the hot months"), 9, 10, 11, 17, 0.5},
                {NM_TEXT("winter"), 12, 2, 9, 16, -0.5}};
    if (fromEquatorDeg < coldDeg)
        return {{NM_TEXT("hot months"), 6, 8, 11, 17, 1},
                {NM_TEXT("before the hot months"), 5, 5, 12, 16, 0.5},
                {NM_TEXT("after the hot months"), 9, 9, 12, 16, 0.5},
                {NM_TEXT("winter"), 11, 2, 9, 16, -1},
                {NM_TEXT("early spring"), 3, 3, 9, 17, -0.5}};
    return {{NM_TEXT("hot month"), 7, 7, 12, 16, 0.5}, {NM_TEXT("winter"), 10, 4, 9, 17, -1}};
}

WeightedSeason growingSeason(double fromEquatorDeg) {
    if (fromEquatorDeg < tropicDeg) return {NM_TEXT("growing season"), 1, 12, 6, 20, -1};
    if (fromEquatorDeg < subtropicsDeg) return {NM_TEXT("growing season"), 3, 10, 6, 20, -1};
    if (fromEquatorDeg < coldDeg) return {NM_TEXT("growing season"), 4, 9, 6, 20, -1};
    return {NM_TEXT("growing season"), 5, 8, 6, 20, -1};
}

}  // namespace

TimeWeights makeComfortWeights(double latitudeDeg) {
    return makeSeasons(NM_TEXT("pedestrian comfort"), comfortSeasons(std::abs(latitudeDeg)), latitudeDeg);
}

TimeWeights makePlantWeights(double latitudeDeg) {
    return makeSeasons(NM_TEXT("plants"), {growingSeason(std::abs(latitudeDeg))}, latitudeDeg);
}

namespace {

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
    const std::string days = text(interval.first) + " to " + text(interval.last);
    if (interval.to - interval.from == hours(24)) return days;
    const auto clock = [](minutes time) {
        return fmt::format("{:02}:{:02}", time.count() / 60, time.count() % 60);
    };
    return days + ", " + clock(interval.from) + " to " + clock(interval.to);
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

// Ends are excluded.
struct Range {
    int first = 0, end = 0;
    [[nodiscard]] int size() const { return end - first; }
    bool operator==(const Range&) const = default;
};

Range meet(Range a, Range b) { return {std::max(a.first, b.first), std::min(a.end, b.end)}; }

// Days of a leap year, and minutes of each of them.
struct Box {
    Range days, minutes;
};

int minutesOf(const Box& box) { return std::max(0, box.days.size()) * std::max(0, box.minutes.size()); }

Box meet(const Box& a, const Box& b) { return {meet(a.days, b.days), meet(a.minutes, b.minutes)}; }

// The range, or its two parts where it spans the end.
std::vector<Range> unwrap(int first, int end, int whole) {
    if (first < end) return {{first, end}};
    return {{first, whole}, {0, end}};
}

std::vector<Box> boxesOf(const WeightedInterval& interval) {
    constexpr int dayMinutes = 24 * 60;
    std::vector<Box> boxes;
    for (const Range dates : unwrap(dayOf(interval.first), dayOf(interval.last) + 1, yearDays))
        for (const Range times : unwrap(int(interval.from.count()), int(interval.to.count()), dayMinutes))
            if (const Box box{dates, times}; minutesOf(box) > 0) boxes.push_back(box);
    return boxes;
}

Box boxOf(const MonthsAndHours& time) {
    const month_day last(time.lastMonth, (leapYear / time.lastMonth / std::chrono::last).day());
    return {{dayOf(time.firstMonth / 1), dayOf(last) + 1}, {time.fromHour * 60, time.toHour * 60}};
}

// The whole days before and after the hole, and the hours before and after it on its own days.
std::vector<Box> cutOut(const Box& box, const Box& hole) {
    const Box gap = meet(box, hole);
    if (minutesOf(gap) == 0) return {box};
    std::vector<Box> pieces{{{box.days.first, gap.days.first}, box.minutes},
                            {gap.days, {box.minutes.first, gap.minutes.first}},
                            {gap.days, {gap.minutes.end, box.minutes.end}},
                            {{gap.days.end, box.days.end}, box.minutes}};
    std::erase_if(pieces, [](const Box& piece) { return minutesOf(piece) == 0; });
    return pieces;
}

std::optional<Range> join(Range a, Range b) {
    if (a.end == b.first) return Range{a.first, b.end};
    return b.end == a.first ? std::optional(Range{b.first, a.end}) : std::nullopt;
}

// Dates follow each other around the year, too: the range may end behind it.
std::optional<Range> joinDays(Range a, Range b) {
    if (a.size() + b.size() > yearDays) return std::nullopt;
    if (a.end % yearDays == b.first % yearDays) return Range{a.first, a.end + b.size()};
    return b.end % yearDays == a.first % yearDays ? std::optional(Range{b.first, b.end + a.size()})
                                                  : std::nullopt;
}

// Two boxes that make one.
std::optional<Box> join(const Box& a, const Box& b) {
    if (a.minutes == b.minutes)
        if (const auto dates = joinDays(a.days, b.days)) return Box{*dates, a.minutes};
    if (a.days == b.days)
        if (const auto times = join(a.minutes, b.minutes)) return Box{a.days, *times};
    return std::nullopt;
}

WeightedInterval intervalOf(const Box& box, double weight, std::string name = {}) {
    WeightedInterval interval{std::move(name),          dateOf(box.days.first),
                              dateOf(box.days.end - 1), minutes(box.minutes.first),
                              minutes(box.minutes.end), weight};
    if (interval.name.empty()) interval.name = nameOf(interval);
    return interval;
}

// A piece of a painted interval is one, too, and gets the name of its own time.
std::string pieceName(const WeightedInterval& interval) {
    return interval.name == nameOf(interval) ? std::string() : interval.name;
}

// Around New Year as one; none where its hours span midnight.
std::optional<Box> wholeBoxOf(const WeightedInterval& interval) {
    const int first = dayOf(interval.first);
    const Box box{{first, first + lengthOf(interval)},
                  {int(interval.from.count()), int(interval.to.count())}};
    return minutesOf(box) > 0 ? std::optional(box) : std::nullopt;
}

// The pieces of an interval over New Year that lie on both sides of it become one again.
std::vector<Box> joinOverNewYear(std::vector<Box> pieces) {
    const auto atEnd = std::ranges::find(pieces, yearDays, [](const Box& box) { return box.days.end; });
    if (atEnd == pieces.end()) return pieces;
    const auto next = std::ranges::find_if(pieces, [&](const Box& box) {
        return &box != &*atEnd && box.days.first == 0 && box.minutes == atEnd->minutes;
    });
    if (next == pieces.end()) return pieces;
    atEnd->days = *joinDays(atEnd->days, next->days);
    pieces.erase(next);
    return pieces;
}

// Names of several intervals: of pieces that were cut from one.
std::set<std::string> listCutNames(const TimeWeights& table) {
    std::set<std::string> once, again;
    for (const WeightedInterval& one : table.intervals)
        if (!once.insert(one.name).second) again.insert(one.name);
    return again;
}

// Neighbours of the same weight become part of it: painted ones, and pieces of an interval in which it fills
// a hole. Intervals with a name of their own stay apart.
WeightedInterval withNeighbours(TimeWeights& table, Box box, double weight) {
    const std::set<std::string> cut = listCutNames(table);
    const auto extends = [&](const WeightedInterval& one) {
        const auto whole = wholeBoxOf(one);
        return one.weight == weight && (one.name == nameOf(one) || cut.contains(one.name)) && whole &&
               join(box, *whole);
    };
    std::string name;
    auto& all = table.intervals;
    for (auto found = std::ranges::find_if(all, extends); found != all.end();
         found = std::ranges::find_if(all, extends)) {
        box = *join(box, *wholeBoxOf(*found));
        if (name.empty()) name = pieceName(*found);
        all.erase(found);
    }
    return intervalOf(box, weight, name);
}

WeightCell cellOf(const TimeWeights& table, const Box& cell) {
    int held = 0;
    double sum = 0, minimum = 1, maximum = -1;
    for (const WeightedInterval& interval : table.intervals)
        for (const Box& box : boxesOf(interval)) {
            const int shared = minutesOf(meet(box, cell));
            if (shared == 0) continue;
            held += shared;
            sum += shared * interval.weight;
            minimum = std::min(minimum, interval.weight);
            maximum = std::max(maximum, interval.weight);
        }
    if (held == 0) return {};
    return {true, held < minutesOf(cell) || minimum < maximum, sum / held};
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

Result<TimeWeights> paintWeights(const TimeWeights& table, const MonthsAndHours& time,
                                 std::optional<double> weight) {
    const Box hole = boxOf(time);
    if (minutesOf(hole) == 0) return failure("No hour is chosen", table.name, "Choose at least one hour");
    TimeWeights next{table.name, {}};
    for (const WeightedInterval& interval : table.intervals) {
        const auto boxes = boxesOf(interval);
        const auto overlaps = [&](const Box& box) { return minutesOf(meet(box, hole)) > 0; };
        if (std::ranges::none_of(boxes, overlaps)) {
            next.intervals.push_back(interval);
            continue;
        }
        std::vector<Box> pieces;
        for (const Box& box : boxes) std::ranges::move(cutOut(box, hole), std::back_inserter(pieces));
        for (const Box& piece : joinOverNewYear(std::move(pieces)))
            next.intervals.push_back(intervalOf(piece, interval.weight, pieceName(interval)));
    }
    if (weight) next.intervals.push_back(withNeighbours(next, hole, *weight));
    return validate(next).map([&] { return std::move(next); });
}

std::array<std::array<WeightCell, 24>, 12> weightGrid(const TimeWeights& table) {
    std::array<std::array<WeightCell, 24>, 12> grid;
    for (unsigned at = 0; at < 12; ++at)
        for (int hour = 0; hour < 24; ++hour)
            grid[at][std::size_t(hour)] =
                cellOf(table, boxOf({month(at + 1), month(at + 1), hour, hour + 1}));
    return grid;
}

}  // namespace noonmark
