#include "app/cli/options/period_options.h"

#include "app/cli/options/number_range.h"

namespace noonmark::cli {

namespace {

Result<std::string> zoneFrom(const PeriodOptions& options) {
    if (options.zone.empty() && !options.window.empty())
        return std::string("UTC");  // the zone only defines the dates
    if (options.zone.empty())
        return failure("The hours need a time zone", "period",
                       "Give --zone, for example --zone America/New_York");
    return Zone::named(options.zone).map([](const Zone& zone) { return zone.name(); });
}

Result<void> readTexts(const PeriodOptions& options, Period& period) {
    const auto start = parseDate(options.start);
    if (!start) return tl::make_unexpected(start.error());
    period.start = *start;
    if (!options.from.empty()) {
        const auto from = parseTimeOfDay(options.from);
        if (!from) return tl::make_unexpected(from.error());
        period.from = *from;
    }
    if (options.window.empty()) return {};
    const auto window = parseSolarWindow(options.window);
    if (!window) return tl::make_unexpected(window.error());
    period.window = *window;
    if (options.centre) period.window->rule = SunriseRule::centre;
    return {};
}

}  // namespace

CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options) {
    Period& period = options.period;
    CLI::Option* start =
        command.add_option(options.startOption, options.start, "First day: 2026-03-21")->type_name("DATE");
    command.add_option("--days", period.days, "Number of days")
        ->capture_default_str()
        ->check(CLI::Range(1, 3660))
        ->type_name("N");
    CLI::Option* from =
        command.add_option(options.hourOption, options.from, "Local time of the first step (default 09:00)")
            ->type_name("HH:MM");
    CLI::Option* hours =
        command.add_option("--hours", period.hours, "Hours a day, 0 to 24; 0 is one instant")
            ->capture_default_str()
            ->check(within(0.0, 24.0))
            ->type_name("H");
    CLI::Option* window =
        command
            .add_option(
                "--window", options.window,
                "Hours relative to sunrise and sunset: sunrise+1.5h..sunset-1.5h; every minute counts")
            ->excludes(from)
            ->excludes(hours)
            ->type_name("WINDOW");
    command
        .add_flag("--centre", options.centre,
                  "Define sunrise and sunset of --window by the sun's centre at 0 deg, not by its upper limb "
                  "on the horizon (-0.833 deg)")
        ->needs(window);
    command
        .add_option("--step", period.stepMinutes,
                    "Length of a step, minutes; adjusted so that whole steps fill the hours of each day")
        ->capture_default_str()
        ->check(within(1.0 / 60, 240.0))
        ->type_name("MIN");
    command.add_option("--zone", options.zone, "Time zone, for example America/New_York")->type_name("ZONE");
    command.add_flag("--no-refraction", options.noRefraction,
                     "Use the geometric position of the sun, as planning rules do");
    return start;
}

Result<Period> periodFrom(const PeriodOptions& options) {
    Period period = options.period;
    const auto zone = zoneFrom(options);
    if (!zone) return tl::make_unexpected(zone.error());
    period.zone = *zone;
    period.refraction = !options.noRefraction;
    if (auto read = readTexts(options, period); !read) return tl::make_unexpected(read.error());
    return validate(period);
}

}  // namespace noonmark::cli
