#include "app/cli/project/drawn_times.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/options/number_range.h"
#include "app/cli/project/project_question.h"
#include "core/measures/place_run.h"
#include "core/sun/window_steps.h"

namespace noonmark::cli {

namespace {

/// Minutes since midnight, in order.
Result<std::vector<std::chrono::minutes>> timesOfDay(const DrawnTimeOptions& options) {
    std::vector<std::chrono::minutes> times;
    for (const std::string& text : options.times) {
        const auto time = parseTimeOfDay(text);
        if (!time) return tl::make_unexpected(time.error());
        times.push_back(*time);
    }
    for (int minute = 0; options.everyMin > 0 && minute < 24 * 60; minute += options.everyMin)
        times.emplace_back(minute);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.empty())
        return failure("The times are missing", "times", "Give --times 09:00,12:00 or --every 60");
    return times;
}

struct NamedWindow {
    DayWindow window;
    std::string clock;  // "09:00"
};

Result<std::vector<NamedWindow>> windowsOf(const DrawnTimeOptions& options, const Zone& zone) {
    const auto times = timesOfDay(options);
    if (!times) return tl::make_unexpected(times.error());
    std::vector<NamedWindow> windows;
    for (const std::string& text : options.days) {
        const auto day = parseDate(text);
        if (!day) return tl::make_unexpected(day.error());
        for (const std::chrono::minutes time : *times)
            windows.push_back({{*day, zone.instantAt(*day, time), 1}, formatText(time)});
    }
    std::ranges::stable_sort(windows, {}, [](const NamedWindow& named) { return named.window.from; });
    return windows;
}

DrawnTime timeOf(const NamedWindow& named, const SunStep& sun, const Zone& zone) {
    const std::string day = formatText(named.window.date);
    std::string digits = named.clock;
    std::erase(digits, ':');
    return {day + "_" + digits, day, fmt::format("{} {} {}", day, named.clock, zone.name()), sun};
}

Result<Box2> boxOfPlaces(const std::vector<std::string>& names, const Project& project) {
    Box2 box;
    for (const std::string& name : names) {
        const auto place = findPlace(project, name);
        if (!place) return tl::make_unexpected(place.error());
        for (const Footprint& polygon : place->polygons) box.add(bounds(polygon));
    }
    return box;
}

}  // namespace

Result<std::vector<DrawnTime>> listDrawnTimes(const DrawnTimeOptions& options, const City& city,
                                              Warnings& warnings) {
    const auto zone = Zone::named(options.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto named = windowsOf(options, *zone);
    if (!named) return tl::make_unexpected(named.error());
    std::vector<DayWindow> windows;
    for (const NamedWindow& one : *named) windows.push_back(one.window);
    const auto sun = computeSunSteps(windows, {.stepMinutes = 1}, observerOfPlaces(city));
    if (!sun) return tl::make_unexpected(sun.error());
    std::vector<DrawnTime> times;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (sun->days[i].count > 0)
            times.push_back(timeOf((*named)[i], sun->steps[sun->days[i].first], *zone));
        else if (options.everyMin == 0)
            warnings.push_back({WarningKind::leftOut, "a time with the sun below the horizon",
                                formatText(windows[i].date) + " " + (*named)[i].clock});
    }
    if (!times.empty()) return times;
    return failure("The sun is below the horizon at all times", "times", "Choose other times or days");
}

CLI::Option* addDrawnTimeOptions(CLI::App& command, DrawnTimeOptions& options) {
    CLI::Option* day = command.add_option("--day", options.days, "A day; may be repeated")
                           ->delimiter(',')
                           ->type_name("YYYY-MM-DD");
    CLI::Option* times =
        command.add_option("--times", options.times, "Times of day")->delimiter(',')->type_name("HH:MM,...");
    command.add_option("--every", options.everyMin, "Every so many minutes while the sun is up")
        ->check(within(1, 720))
        ->excludes(times)
        ->type_name("MIN");
    command.add_option("--zone", options.zone, "Time zone of the times")->required()->type_name("ZONE");
    return day;
}

void addDrawnAreaOptions(CLI::App& command, DrawnAreaOptions& options) {
    CLI::Option* region = command.add_option(
        "--region", options.region,
        "Draw the box around this region or place, a box in degrees, a polygon or a file (default: as far as "
        "the shadows of what changes reach)");
    region->type_name("REGION");
    command.add_option("--place", options.places, "Draw the box around this place; may be repeated")
        ->allow_extra_args(false)
        ->excludes(region)
        ->type_name("NAME");
}

Result<std::optional<Box2>> findDrawnArea(const DrawnAreaOptions& options, const Project& project,
                                          const City& city) {
    if (!options.region.empty())
        return regionIn(project, city, options.region).map([](const Region& region) {
            return std::optional(bounds(region));
        });
    if (options.places.empty()) return std::nullopt;
    return boxOfPlaces(options.places, project).map([](const Box2& box) { return std::optional(box); });
}

}  // namespace noonmark::cli
