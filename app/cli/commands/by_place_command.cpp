#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/options/field_options.h"
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
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

struct ByPlaceOptions {
    StudyOptions study;
    PlaceOptions place;
    std::vector<std::string> from;  // further files of places
    std::vector<std::string> scenarios;
    SunByPlaceSettings settings;
};

std::vector<std::string> listFiles() { return {"places.csv", "places.gpkg", "places.json"}; }

Result<PlacesRead> readPlacesOf(const ByPlaceOptions& options, const StudyRequest& request,
                                Progress& progress, const std::stop_token& stop) {
    const Frame& frame = request.loaded.read.city.frame;
    PlacesRead own;
    if (request.project) {
        own.places = request.project->project().places;
    } else {
        auto read = loadCityPlaces(options.study.read.files, options.place.settings, frame, progress, stop);
        if (!read) return read;
        own = *std::move(read);
    }
    auto all = loadPlaceFiles(options.from, options.place.settings, frame, std::move(own), progress, stop);
    if (all) std::erase_if(all->places, [&](const Place& place) { return !options.place.admits(place); });
    return all;
}

// The city asked for, then those of the scenarios that are compared with it.
Result<std::vector<NamedCity>> listCities(const ByPlaceOptions& options, const StudyRequest& request) {
    const std::string& baseline = options.study.scenario;
    std::vector<NamedCity> cities{{baseline.empty() ? existingCity : baseline, request.loaded.read.city}};
    if (!options.scenarios.empty() && !request.project)
        return failure("Only a project has scenarios", "--scenario " + options.scenarios.front(),
                       "Give one project file, NAME.noonmark.gpkg");
    for (const std::string& name : options.scenarios) {
        auto city = cityOf(request.project->project(), name);
        if (!city) return tl::make_unexpected(city.error());
        cities.push_back({name, std::move(city->city)});
    }
    return cities;
}

// States what each city was made from.
void addSources(SunOfCities& sun, const StudyRequest& request) {
    sun.baseline.provenance = provenanceOf(request);
    sun.baseline.seconds["read"] = request.loaded.seconds;
    for (ComparedSun& one : sun.compared)
        one.sun.provenance = provenanceOf(request.project->project(), request.project.get(),
                                          {one.sun.name, sun.baseline.name, request.settings.region, {}});
}

// Ground without a roof over it is measured, whatever a setting of receivers says.
tl::expected<SunOfCities, Failure> measurePlaces(const ByPlaceOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    auto request = parseStudyRequest(options.study, listFiles(), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    const auto cities = orCode(listCities(options, *request), exitUsage);
    if (!cities) return tl::make_unexpected(cities.error());
    auto places = orCode(readPlacesOf(options, *request, progress, interrupt.token()), exitUsage);
    if (!places) return tl::make_unexpected(places.error());
    SunByPlaceSettings settings = options.settings;
    settings.study = request->settings;
    auto sun = orCode(compareSunByPlace(*cities, std::move(places->places), settings, progress,
                                        interrupt.token(), enginesWith(settings.study.engine)),
                      exitFailed);
    if (!sun) return sun;
    Warnings& warnings = sun->baseline.warnings;
    for (const Warnings* read : {&places->warnings, &request->loaded.read.warnings})
        warnings.insert(warnings.begin(), read->begin(), read->end());
    addSources(*sun, *request);
    return sun;
}

Result<std::vector<std::filesystem::path>> writeFiles(const SunOfCities& all, const ByPlaceOptions& options) {
    const OffscreenQt qt;
    const SunByPlace& sun = all.baseline;
    const ElementTable table = makeTable(sun, all.compared);
    OutputFolder files(options.study.out, outputRulesOf(options.study, sun.provenance.inputs));
    files.add("places.csv", textContent(toCsv(table)));
    files.add("places.gpkg", [&](const std::filesystem::path& file) {
        return writePlacesGeoPackage(file, sun.city.frame, sun.places, table);
    });
    files.add("places.json", textContent(toJson(sun, all.compared)));
    return std::move(files).result();
}

std::string describeSun(const SunOfPlace& of) {
    if (of.areaM2 == 0) return "no cell on open ground";
    return fmt::format("{:5.2f} h of sun a day ({:.2f} to {:.2f}), {:5.1f} % with enough", of.meanHours,
                       of.minHours, of.maxHours, 100 * of.enoughShare);
}

std::string describeError(const SunByPlace& sun) {
    if (!sun.error) return "not measured";
    return fmt::format("{:.3f} % mean, {:.2f} % largest, against rays",
                       sun.error->gross.percent(sun.error->gross.meanMin),
                       sun.error->gross.percent(sun.error->gross.maxMin));
}

std::string describeChange(const ComparedSun& compared, std::size_t i) {
    const SunChange& change = compared.changes[i];
    if (std::isnan(change.meanHours)) return {};
    return fmt::format("  {}: {:+.2f} h, at most {:.0f} min less, {:.1f} % loses", compared.sun.name,
                       change.meanHours, change.maxLossMin, 100 * change.lostShare);
}

void printPlaces(const SunOfCities& all, std::ostream& out) {
    constexpr std::size_t maxListed = 40;
    const SunByPlace& sun = all.baseline;
    for (std::size_t i = 0; i < std::min(maxListed, sun.places.size()); ++i) {
        out << fmt::format("{:<44} {:<13} {}", sun.places[i].name, nameOf(sun.places[i].kind),
                           describeSun(sun.sun[i]));
        for (const ComparedSun& one : all.compared) out << describeChange(one, i);
        out << '\n';
    }
    if (sun.places.size() > maxListed)
        out << fmt::format("and {} more, in places.csv\n", withCommas(sun.places.size() - maxListed));
}

void addComparison(Table& table, const SunOfCities& all) {
    if (all.compared.empty()) return;
    table.add("baseline", all.baseline.name);
    table.add("loss", fmt::format("more than {:g} min of sun a day counts", all.baseline.settings.lossMin));
    for (const ComparedSun& one : all.compared) table.add("error, " + one.sun.name, describeError(one.sun));
}

void printSun(const SunOfCities& all, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    const SunByPlace& sun = all.baseline;
    Table table;
    table.add("period", formatText(sun.settings.study.period));
    table.add("engine", sun.field.engine);
    table.add("places", withCommas(sun.places.size()));
    table.add("possible", fmt::format("{:.2f} h of sun a day without any shadow", sun.possibleHours));
    table.add("enough", fmt::format("{:g} h of sun a day", sun.settings.enoughHours));
    if (sun.error) table.add("error of cells", describeError(sun));
    addComparison(table, all);
    table.add("time", fmt::format("{:.2f} s", sun.seconds.at("total")));
    table.print(out);
    out << '\n';
    printPlaces(all, out);
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
        console.out << toJson(sun->baseline, sun->compared) << '\n';
    else
        printSun(*sun, *files, console.out);
    return exitOk;
}

void addScenarioOptions(CLI::App& command, ByPlaceOptions& options) {
    command
        .add_option(flags::scenario, options.scenarios,
                    "Scenario of the project to compare with the baseline; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command
        .add_option("--baseline", options.study.scenario,
                    "Scenario of the project to measure first (default: the existing city)")
        ->type_name("NAME");
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
    addScenarioOptions(*command, *options);
    const std::vector<CLI::Option*> before = command->get_options();
    addPeriodOptions(*command, study.period);
    addNamedPeriod(*command, before, study.periodName);
    command->add_option("--places-from", options->from, "Also the places of this file; may be repeated")
        ->allow_extra_args(false)
        ->type_name("FILE");
    constexpr double defaultSidewalkM = 4;
    options->place.settings.sidewalkM = defaultSidewalkM;
    addPlaceOptions(*command, options->place);
    addFieldOptions(*command, sunByPlaceFields().of(options->settings));
    addCellOptions(*command, study.settings);
    addEngineOptions(*command, study.settings);
    addErrorOptions(*command, study.settings.errorSample);
    command->add_option(flags::out, study.out, "Folder for places.csv, places.gpkg and places.json")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(*command, study.overwrite);
    addJsonFlag(*command, study.json, "Print only places.json to standard output");
    command->footer(
        "The parks and squares of a city over a year:\n"
        "  noonmark-cli by-place city.osm.pbf --kind park --kind plaza --start 2026-01-01 --days 365 \\\n"
        "    --window sunrise..sunset --zone America/New_York --cell 2 --date 2026-12-21 --out out");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runByPlace(*options, console); };
    });
}

}  // namespace noonmark::cli
