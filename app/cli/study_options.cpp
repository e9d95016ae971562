#include "app/cli/study_options.h"

#include "app/cli/engine_options.h"
#include "app/cli/number_range.h"

namespace noonmark::cli {

namespace {

void addPeriodOptions(CLI::App& command, StudyOptions& options) {
    Period& period = options.settings.period;
    command.add_option("--start", options.start, "First day: 2026-03-21")->required()->type_name("DATE");
    command.add_option("--days", period.days, "How many days")
        ->capture_default_str()
        ->check(CLI::Range(1, 3660))
        ->type_name("N");
    CLI::Option* from =
        command.add_option("--from", options.from, "Wall clock of the first step (default 09:00)")
            ->type_name("HH:MM");
    CLI::Option* hours =
        command.add_option("--hours", period.hours, "Hours a day, 0 to 24; 0 is one instant")
            ->capture_default_str()
            ->check(within(0.0, 24.0))
            ->type_name("H");
    CLI::Option* window =
        command
            .add_option("--window", options.window, "Hours counted from the sun: sunrise+1.5h..sunset-1.5h")
            ->excludes(from)
            ->excludes(hours)
            ->type_name("WINDOW");
    command
        .add_flag(
            "--centre", options.centre,
            "Sunrise and sunset of --window are the sun's centre at 0 deg, not its upper limb seen on the "
            "horizon (-0.833 deg)")
        ->needs(window);
    command.add_option("--step", period.stepMinutes, "Minutes from step to step")
        ->capture_default_str()
        ->check(within(1.0 / 60, 240.0))
        ->type_name("MIN");
    command.add_option("--zone", options.zone, "Zone of the wall clock: America/New_York")->type_name("ZONE");
    command.add_flag("--no-refraction", options.noRefraction, "The geometric sun, as rules on plans mean it");
}

Result<std::string> zoneFrom(const StudyOptions& options) {
    if (options.zone.empty() && !options.window.empty()) return std::string("UTC");  // only names the days
    if (options.zone.empty())
        return failure("The hours need a zone to be hours of", "study",
                       "State --zone, for example --zone America/New_York");
    return Zone::named(options.zone).map([](const Zone& zone) { return zone.name(); });
}

Result<void> readTexts(const StudyOptions& options, Period& period) {
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

void addStudyOptions(CLI::App& command, StudyOptions& options) {
    addReadOptions(command, options.read);
    addPeriodOptions(command, options);
    StudySettings& settings = options.settings;
    command
        .add_option("--region", options.region,
                    "Where to measure: west,south,east,north in degrees, or a polygon file")
        ->required()
        ->type_name("W,S,E,N|FILE");
    command.add_option("--cell", settings.receivers.cellM, "Size of a cell, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    command.add_option("--pressure", settings.pressureHPa, "Of the air, for refraction, hPa")
        ->capture_default_str()
        ->check(within(0.0, 1200.0))
        ->type_name("HPA");
    command.add_option("--temperature", settings.temperatureC, "Of the air, for refraction, deg C")
        ->capture_default_str()
        ->check(within(-90.0, 60.0))
        ->type_name("C");
    addEngineOptions(command, settings);
    command.add_option("--out", options.out, "Folder for the maps, the report and study.json")
        ->required()
        ->type_name("DIR");
    command
        .add_option_function<std::string>(
            "--by", [&settings](const std::string&) { settings.byMonth = true; },
            "month: the shadow of each month, as bands and a table (engine horizon)")
        ->check(CLI::IsMember({"month"}))
        ->type_name("SET");
    command.add_flag("--contributions", settings.contributions,
                     "What each building shades, and shades alone, as a table and a map (engine horizon)");
    command.add_flag("--cells-csv", options.cellsCsv, "Write cells.csv too: one line a receiver");
    command.add_flag("--json", options.json, "study.json on standard output, nothing else");
}

Result<Period> periodFrom(const StudyOptions& options) {
    Period period = options.settings.period;
    const auto zone = zoneFrom(options);
    if (!zone) return tl::make_unexpected(zone.error());
    period.zone = *zone;
    period.refraction = !options.noRefraction;
    if (auto read = readTexts(options, period); !read) return tl::make_unexpected(read.error());
    return checked(period);
}

}  // namespace noonmark::cli
