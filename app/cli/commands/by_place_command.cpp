#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/options/number_range.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/options/place_options.h"
#include "app/cli/options/project_question.h"
#include "app/cli/study/load_city.h"
#include "app/cli/study/study_request.h"
#include "app/input/all_engines.h"
#include "app/input/load_places.h"
#include "app/report/files/output_folder.h"
#include "core/describe/command_flags.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/element_tables.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

struct ByPlaceOptions {
    StudyOptions study;
    PlaceOptions place;
    std::vector<std::string> from;  // further files of places
    SunByPlaceSettings settings;
};

std::vector<std::string> listFiles() { return {"places.csv", "places.gpkg", "places.json"}; }

Result<PlacesRead> readPlacesOf(const ByPlaceOptions& options, const Frame& frame, Progress& progress,
                                const std::stop_token& stop) {
    PlacesRead own;
    if (namesProject(options.study.read)) {
        const auto disk = ProjectFile::open(options.study.read.files.front());
        if (!disk) return tl::make_unexpected(disk.error());
        own.places = disk->project().places;
    } else {
        auto read = loadCityPlaces(options.study.read.files, options.place.settings, frame, progress, stop);
        if (!read) return read;
        own = *std::move(read);
    }
    auto all = loadPlaceFiles(options.from, options.place.settings, frame, std::move(own), progress, stop);
    if (all) std::erase_if(all->places, [&](const Place& place) { return !options.place.admits(place); });
    return all;
}

// Ground without a roof over it is measured, whatever a setting of receivers says.
tl::expected<SunByPlace, Failure> measurePlaces(const ByPlaceOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    auto request = parseStudyRequest(options.study, listFiles(), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    const City& city = request->loaded.read.city;
    auto places = orCode(readPlacesOf(options, city.frame, progress, interrupt.token()), exitUsage);
    if (!places) return tl::make_unexpected(places.error());
    SunByPlaceSettings settings = options.settings;
    settings.study = request->settings;
    auto sun = orCode(runSunByPlace(city, std::move(places->places), settings, progress, interrupt.token(),
                                    enginesWith(settings.study.engine)),
                      exitFailed);
    if (!sun) return sun;
    for (const Warnings* read : {&places->warnings, &request->loaded.read.warnings})
        sun->warnings.insert(sun->warnings.begin(), read->begin(), read->end());
    sun->provenance = provenanceOf(*request);
    sun->seconds["read"] = request->loaded.seconds;
    return sun;
}

Result<std::vector<std::filesystem::path>> writeFiles(const SunByPlace& sun, const ByPlaceOptions& options) {
    const OffscreenQt qt;
    const ElementTable table = makeTable(sun);
    OutputFolder files(options.study.out, outputRulesOf(options.study, sun.provenance.inputs));
    files.add("places.csv", textContent(toCsv(table)));
    files.add("places.gpkg", [&](const std::filesystem::path& file) {
        return writePlacesGeoPackage(file, sun.city.frame, sun.places, table);
    });
    files.add("places.json", textContent(toJson(sun)));
    return std::move(files).result();
}

std::string describeSun(const SunOfPlace& of) {
    if (of.areaM2 == 0) return "no cell on open ground";
    return fmt::format("{:5.2f} h of sun a day ({:.2f} to {:.2f}), {:5.1f} % with enough", of.meanHours,
                       of.minHours, of.maxHours, 100 * of.enoughShare);
}

void printSun(const SunByPlace& sun, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    constexpr std::size_t maxListed = 40;
    Table table;
    table.add("period", formatText(sun.settings.study.period));
    table.add("engine", sun.field.engine);
    table.add("places", withCommas(sun.places.size()));
    table.add("possible", fmt::format("{:.2f} h of sun a day without any shadow", sun.possibleHours));
    table.add("enough", fmt::format("{:g} h of sun a day", sun.settings.enoughHours));
    if (sun.error)
        table.add("error of cells", fmt::format("{:.3f} % mean, {:.2f} % largest, against rays",
                                                sun.error->gross.percent(sun.error->gross.meanMin),
                                                sun.error->gross.percent(sun.error->gross.maxMin)));
    table.add("time", fmt::format("{:.2f} s", sun.seconds.at("total")));
    table.print(out);
    out << '\n';
    for (std::size_t i = 0; i < std::min(maxListed, sun.places.size()); ++i)
        out << fmt::format("{:<44} {:<13} {}\n", sun.places[i].name, nameOf(sun.places[i].kind),
                           describeSun(sun.sun[i]));
    if (sun.places.size() > maxListed)
        out << fmt::format("and {} more, in places.csv\n", withCommas(sun.places.size() - maxListed));
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, sun.warnings);
}

int runByPlace(const ByPlaceOptions& options, const Console& console) {
    const auto sun = measurePlaces(options, console);
    if (!sun) return fail(console, sun.error().error, sun.error().code);
    const auto files = writeFiles(*sun, options);
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.study.json)
        console.out << toJson(*sun) << '\n';
    else
        printSun(*sun, *files, console.out);
    return exitOk;
}

void addSunOptions(CLI::App& command, SunByPlaceSettings& settings) {
    command
        .add_option("--enough", settings.enoughHours,
                    "Hours of sun a day that are enough: the share of each place that has them is stated")
        ->capture_default_str()
        ->check(within(0, SunByPlaceSettings::maxHours))
        ->type_name("H");
    command
        .add_option_function<std::vector<std::string>>(
            "--date",
            [&settings](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    if (const auto date = parseDate(text)) settings.dates.push_back(*date);
            },
            "A day: the share of each place with less than enough sun on it is stated; may be repeated")
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            return parseDate(text) ? std::string() : "'" + text + "' is not a date: 2026-12-21";
        })
        ->type_name("DATE");
}

}  // namespace

void addByPlaceCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ByPlaceOptions>();
    StudyOptions& study = options->study;
    CLI::App* command = app.add_subcommand(
        "by-place", "Measure how much sun parks, squares, streets and other places get, in one table");
    study.region = "city";
    study.read.filesHelp += ", or one project: NAME.noonmark.gpkg";
    addReadOptions(*command, study.read);
    command
        ->add_option(flags::scenario, study.scenario,
                     "Scenario of the project to measure (default: the existing city)")
        ->type_name("NAME");
    const std::vector<CLI::Option*> before = command->get_options();
    addPeriodOptions(*command, study.period);
    addNamedPeriod(*command, before, study.periodName);
    command->add_option("--places-from", options->from, "Also the places of this file; may be repeated")
        ->allow_extra_args(false)
        ->type_name("FILE");
    addPlaceOptions(*command, options->place);
    addSunOptions(*command, options->settings);
    addCellOptions(*command, study.settings);
    addEngineOptions(*command, study.settings);
    addErrorOptions(*command, study.settings.errorSample);
    command->add_option(flags::out, study.out, "Folder for places.csv, places.gpkg and places.json")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(*command, study.overwrite);
    command->add_flag("--json", study.json, "Print only places.json to standard output");
    command->footer(
        "The parks and squares of a city over a year:\n"
        "  noonmark-cli by-place city.osm.pbf --kind park --kind plaza --start 2026-01-01 --days 365 \\\n"
        "    --window sunrise..sunset --zone America/New_York --cell 2 --date 2026-12-21 --out out");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runByPlace(*options, console); };
    });
}

}  // namespace noonmark::cli
