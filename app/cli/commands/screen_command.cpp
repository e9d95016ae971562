#include <fmt/format.h>

#include <array>
#include <charconv>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/study_options.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/engines/auto_engine.h"
#include "core/measures/places/place_run.h"
#include "core/measures/places/place_screening.h"
#include "core/study/text/error_text.h"
#include "core/sun/sun_steps.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ScreenOptions {
    std::string file;
    std::vector<std::string> places;
    std::string from, to;
    std::string noShadow;  // "108..252"
    std::string periodName;
    PeriodOptions period{.names = {{"--from", "--at"}, {"--start", "--day,--start"}}};
    ScreeningSettings settings;
    bool json = false;
};

/// What was screened, with the names and the clock of the answer.
struct ScreenAnswer {
    std::vector<Place> places;
    std::vector<ScreenedPlace> screened;
    std::optional<AzimuthSector> sector;
    double lengthFactor = 0;
    Zone zone;
};

Result<std::optional<AzimuthSector>> sectorFrom(const std::string& text) {
    if (text.empty()) return std::optional<AzimuthSector>{};
    const auto dots = text.find("..");
    AzimuthSector sector;
    const auto parse = [](std::string_view part, double& to) {
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), to);
        return error == std::errc{} && end == part.data() + part.size() && to >= 0 && to <= 360;
    };
    if (dots != std::string::npos && parse(std::string_view(text).substr(0, dots), sector.fromDeg) &&
        parse(std::string_view(text).substr(dots + 2), sector.toDeg))
        return std::optional(sector);
    return failure("It is not a sector of azimuths", "--no-shadow " + text,
                   "Give degrees clockwise from north: 108..252");
}

// The equinoxes and solstices, from 1.5 h after sunrise to 1.5 h before sunset, if no day is given.
Result<SunSteps> sunOf(const ScreenOptions& options, const Project& project, bool hoursGiven,
                       const std::stop_token& stop) {
    const bool named = !options.periodName.empty(), days = options.period.states("--start");
    PeriodOptions asked = options.period;
    if (!hoursGiven) asked.period.window = SolarHours{std::chrono::minutes(90), std::chrono::minutes(90)};
    if (!named && !days) {
        asked.period.start =
            std::chrono::year_month_day(std::chrono::year(2026), std::chrono::January, std::chrono::day(1));
        asked.given.emplace("--start");
    }
    auto period = periodIn(project, options.periodName, asked);
    if (!period) return tl::make_unexpected(period.error());
    const Observer observer = observerOfPlaces(*project.city);
    if (named || days) return computeDaylightSteps(*period, observer, stop);
    period->days = 365;
    return computeSunSteps(*period, observer, stop).map([](const SunSteps& year) {
        constexpr std::array<std::size_t, 4> fourDays{79, 171, 263, 354};  // the 21st of Mar, Jun, Sep, Dec
        return chooseDays(year, fourDays);
    });
}

Result<ScreenAnswer> computeScreening(const ScreenOptions& options, bool hoursGiven, const Console& console) {
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return tl::make_unexpected(disk.error());
    const Project& project = disk->project();
    ScreenAnswer answer;
    for (const std::string& name : options.places) {
        auto place = findPlace(project, name);
        if (!place) return tl::make_unexpected(place.error());
        answer.places.push_back(*std::move(place));
    }
    if (options.places.empty()) answer.places = project.places;
    const auto sector = sectorFrom(options.noShadow);
    if (!sector) return tl::make_unexpected(sector.error());
    ScreeningSettings settings = options.settings;
    settings.noShadow = *sector;
    const auto before = cityOf(project, options.from), after = cityOf(project, options.to);
    if (!before) return tl::make_unexpected(before.error());
    if (!after) return tl::make_unexpected(after.error());
    const Interrupt interrupt;
    ProgressLine progress(console);
    const auto sun = sunOf(options, project, hoursGiven, interrupt.token());
    if (!sun) return tl::make_unexpected(sun.error());
    answer.sector = settings.noShadow ? settings.noShadow : findNoShadowSector(*sun);
    answer.lengthFactor = settings.lengthFactor.value_or(findLengthFactor(*sun));
    const auto zone = Zone::named(options.period.period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    answer.zone = *zone;
    return screenPlaces(before->city, after->city, answer.places, *sun, settings, AutoEngine(), progress,
                        interrupt.token())
        .map([&](std::vector<ScreenedPlace> screened) {
            answer.screened = std::move(screened);
            return std::move(answer);
        });
}

void printJson(const ScreenAnswer& answer, std::ostream& out) {
    Json places = Json::array();
    for (const ScreenedPlace& screened : answer.screened) {
        const Place& place = answer.places[screened.place];
        places.push_back(
            {{"name", place.name},
             {"kind", nameOf(place.kind)},
             {"result", nameOf(screened.result)},
             {"reason", screened.reason},
             {"distance_m", screened.distanceM},
             {"azimuth_deg", screened.azimuthDeg},
             {"longest_shadow_m", screened.longestM},
             {"minutes", screened.minutes},
             {"first", screened.first
                           ? Json(answer.zone.text(std::chrono::round<std::chrono::seconds>(*screened.first)))
                           : Json()}});
    }
    Json json{{"length_factor", answer.lengthFactor}, {"no_shadow_sector_deg", Json()}, {"places", places}};
    if (answer.sector) json["no_shadow_sector_deg"] = {answer.sector->fromDeg, answer.sector->toDeg};
    out << toJsonText(json) << '\n';
}

void print(const ScreenAnswer& answer, std::ostream& out) {
    std::size_t reached = 0;
    for (const ScreenedPlace& screened : answer.screened) {
        const Place& place = answer.places[screened.place];
        reached += screened.result == ScreeningResult::reached ? 1 : 0;
        out << fmt::format("{:<44} {:<26} {}\n", place.name, nameOf(screened.result), screened.reason);
    }
    out << fmt::format("Reached: {} of {}; longest shadow {:.2f} x height", reached,
                       countOf(answer.screened.size(), "place"), answer.lengthFactor);
    if (answer.sector)
        out << fmt::format(", none from {:.0f} to {:.0f} deg", answer.sector->fromDeg, answer.sector->toDeg);
    out << '\n';
}

int runScreen(const ScreenOptions& options, bool hoursGiven, const Console& console) {
    const auto answer = computeScreening(options, hoursGiven, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    options.json ? printJson(*answer, console.out) : print(*answer, console.out);
    return exitOk;
}

}  // namespace

void addScreenCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ScreenOptions>();
    CLI::App* command = app.add_subcommand(
        "screen", "List which places the shadow of a proposal can reach at all, and why the others are not");
    command->add_option("project", options->file, "The project")->required()->type_name("NAME.noonmark.gpkg");
    command->add_option("--place", options->places, "Only this place; may be repeated (default: all)")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command->add_option(flags::from, options->from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::to, options->to, "The scenario with the proposal")
        ->required()
        ->type_name("NAME");
    command
        ->add_option("--length-factor", options->settings.lengthFactor,
                     "Longest shadow per metre of height (default: by the lowest sun; New York takes 4.3)")
        ->check(within(0.1, 1000))
        ->type_name("FACTOR");
    command
        ->add_option("--no-shadow", options->noShadow,
                     "Azimuths into which no shadow falls (default: by the sun; New York takes 108..252)")
        ->type_name("DEG..DEG");
    const std::vector<CLI::Option*> before = command->get_options();
    addPeriodOptions(*command, options->period);
    addNamedPeriod(*command, before, options->periodName);
    command->add_option("--cell", options->settings.cellM, "Size of a cell of the last test, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    addJsonFlag(*command, options->json);
    command->footer(
        "Without days: the equinoxes and solstices of 2026, from 1.5 h after sunrise to 1.5 h before "
        "sunset.");
    command->callback([options, command, &run] {
        const bool hours =
            command->count("--at") + command->count("--hours") + command->count("--window") > 0;
        run = [options, hours](const Console& console) { return runScreen(*options, hours, console); };
    });
}

}  // namespace noonmark::cli
