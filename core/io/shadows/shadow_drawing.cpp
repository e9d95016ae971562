#include "core/io/shadows/shadow_drawing.h"

#include <fmt/format.h>
#include <algorithm>

#include "core/city/terrain/building_ground.h"
#include "core/measures/places/place_run.h"
#include "core/sun/day_clock.h"

namespace noonmark {

namespace {

bool meet(const Box2& a, const Box2& b) {
    return !a.empty() && a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y;
}

}  // namespace

std::string_view nameOf(BuildingState state) {
    switch (state) {
        case BuildingState::unchanged:
            return "unchanged";
        case BuildingState::proposed:
            return "proposed";
        case BuildingState::removed:
            break;
    }
    return "removed";
}

void addBuildings(const City& city, BuildingState state, const Box2& area, std::vector<DrawnPart>& to) {
    for (const auto& building : city.buildings) {
        if (!meet(bounds(*building), area)) continue;
        const auto groundM = double(findGroundUnder(*building, city));
        for (const Part& part : building->parts)
            to.push_back({building->sourceId, building->name, state, part.footprint,
                          double(part.bottomM) - groundM, double(part.topM) - groundM});
    }
}

std::vector<Place> choosePlacesIn(const std::vector<Place>& places, const Box2& area) {
    std::vector<Place> chosen;
    for (const Place& place : places)
        if (std::ranges::any_of(place.polygons,
                                [&](const Footprint& polygon) { return meet(bounds(polygon), area); }))
            chosen.push_back(place);
    return chosen;
}

namespace {

/// Minutes since midnight, in order.
Result<std::vector<std::chrono::minutes>> timesOfDay(const DrawnTimeChoice& choice) {
    std::vector<std::chrono::minutes> times;
    for (const std::string& text : choice.times) {
        const auto time = parseTimeOfDay(text);
        if (!time) return tl::make_unexpected(time.error());
        times.push_back(*time);
    }
    for (int minute = 0; choice.everyMin > 0 && minute < 24 * 60; minute += choice.everyMin)
        times.emplace_back(minute);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.empty())
        return failure("The times are missing", "times",
                       "Name times such as 09:00, or an interval in minutes");
    return times;
}

struct NamedHours {
    DayHours window;
    std::string clock;  // "09:00"
};

Result<std::vector<NamedHours>> namedHoursOf(const DrawnTimeChoice& choice, const Zone& zone) {
    const auto times = timesOfDay(choice);
    if (!times) return tl::make_unexpected(times.error());
    std::vector<NamedHours> windows;
    for (const std::string& text : choice.days) {
        const auto day = parseDate(text);
        if (!day) return tl::make_unexpected(day.error());
        for (const std::chrono::minutes time : *times)
            windows.push_back({{*day, zone.instantAt(*day, time), 1}, formatText(time)});
    }
    std::ranges::stable_sort(windows, {}, [](const NamedHours& named) { return named.window.from; });
    return windows;
}

DrawnTime timeOf(const NamedHours& named, const SunStep& sun, const Zone& zone) {
    const std::string day = formatText(named.window.date);
    std::string digits = named.clock;
    std::erase(digits, ':');
    return {day + "_" + digits, day, fmt::format("{} {} {}", day, named.clock, zone.name()), sun};
}

}  // namespace

Result<std::vector<DrawnTime>> listDrawnTimes(const DrawnTimeChoice& choice, const City& city,
                                              Warnings& warnings) {
    const auto zone = Zone::named(choice.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto named = namedHoursOf(choice, *zone);
    if (!named) return tl::make_unexpected(named.error());
    std::vector<DayHours> windows;
    for (const NamedHours& one : *named) windows.push_back(one.window);
    const auto sun = computeSunSteps(windows, {.stepMinutes = 1}, observerOfPlaces(city));
    if (!sun) return tl::make_unexpected(sun.error());
    std::vector<DrawnTime> times;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (sun->days[i].count > 0)
            times.push_back(timeOf((*named)[i], sun->steps[sun->days[i].first], *zone));
        else if (choice.everyMin == 0)
            warnings.push_back({WarningKind::leftOut, "a time with the sun below the horizon",
                                formatText(windows[i].date) + " " + (*named)[i].clock});
    }
    if (!times.empty()) return times;
    return failure("The sun is below the horizon at all times", "times", "Choose other times or days");
}

std::vector<std::string> listDaysOf(int year) {
    using namespace std::chrono;
    std::vector<std::string> days;
    const sys_days end = std::chrono::year(year) / December / 31;
    for (sys_days day = std::chrono::year(year) / January / 1; day <= end; day += std::chrono::days(1))
        days.push_back(formatText(CivilDate(day)));
    return days;
}

}  // namespace noonmark
