#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_city.h"
#include "app/questions/question.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/io/read_region.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/place_names.h"
#include "core/study/study_fields.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

constexpr const char* fromFlag = "--places-from";
constexpr const char* regionFlag = "--region";

struct ByPlaceOptions {
    StudyOptions study;
    PlaceOptions place;
    std::vector<std::string> from;     // further files of places
    std::vector<std::string> regions;  // that count as places, too
    std::vector<std::string> scenarios;
    SunByPlaceSettings settings;
    SheetOptions sheets;
    PlaceColours colours;
};

// Of a project also by their names.
Result<void> addRegions(const ByPlaceOptions& options, const StudyRequest& request,
                        std::vector<Place>& places) {
    const City& city = request.loaded.read.city;
    for (const std::string& text : options.regions) {
        const auto region =
            request.project ? regionIn(request.project->project(), city, text) : readRegion(text, city.frame);
        if (!region) return tl::make_unexpected(region.error());
        places.push_back(makePlace(*region));
    }
    if (!options.regions.empty()) makeNamesUnique(places);
    return {};
}

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

// Those that are compared with the city asked for.
Result<std::vector<NamedCity>> listScenarios(const ByPlaceOptions& options, const StudyRequest& request) {
    std::vector<NamedCity> cities;
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

// As they were typed; those of regions and files by name.
std::vector<CommandOption> listPlaceOptions(const ByPlaceOptions& options) {
    const auto fileName = [](const std::string& file) {
        return std::filesystem::path(file).filename().string();
    };
    std::vector<CommandOption> listed = listOptions(options.place);
    for (const std::string& file : options.from) listed.push_back({fromFlag, {fileName(file)}});
    for (const std::string& region : options.regions) listed.push_back({regionFlag, {region}});
    return listed;
}

// Of a comparison, as of others: from the baseline to the last scenario, whose figures maps and sheets show.
Provenance statedOf(const ByPlaceOptions& options, const StudyRequest& request, const std::string& baseline) {
    if (options.scenarios.empty() || !request.project) return provenanceOf(request);
    return provenanceOf(request.project->project(), request.project.get(),
                        {options.scenarios.back(), baseline, request.settings.region, {}});
}

// A baseline and scenarios alike are measured on ground without a roof over it.
Result<Asked> makeAsked(const ByPlaceOptions& options, const StudyRequest& request, Progress& progress,
                        const std::stop_token& stop) {
    const std::string baseline = options.study.scenario.empty() ? existingCity : options.study.scenario;
    Asked asked{.loaded = request.loaded,
                .scenario = baseline,
                .settings = request.settings,
                .byPlace = options.settings,
                .placesAsked = {listPlaceOptions(options)},
                .provenance = statedOf(options, request, baseline)};
    auto scenarios = listScenarios(options, request);
    if (!scenarios) return tl::make_unexpected(scenarios.error());
    asked.others = *std::move(scenarios);
    auto places = readPlacesOf(options, request, progress, stop);
    if (!places) return tl::make_unexpected(places.error());
    if (auto added = addRegions(options, request, places->places); !added)
        return tl::make_unexpected(added.error());
    asked.places = std::move(places->places);
    prependWarnings(asked.loaded.read.warnings, places->warnings);
    return asked;
}

std::string describeForecast(double seconds) {
    constexpr double minute = 60;
    return seconds < 2 * minute ? fmt::format("about {:.0f} s", std::max(1.0, seconds))
                                : fmt::format("about {:.0f} min", seconds / minute);
}

/// The answer, and how its files look.
struct MeasuredPlaces {
    std::shared_ptr<const Answer> answer;
    BookSettings book;
    std::shared_ptr<const ProjectFile> project;
};

tl::expected<MeasuredPlaces, Failure> measurePlaces(const ByPlaceOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    const auto request =
        parseStudyRequest(options.study, byPlaceFileNames(options.sheets.wanted, options.settings.dates),
                          progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    auto asked = orCode(makeAsked(options, *request, progress, interrupt.token()), exitUsage);
    if (!asked) return tl::make_unexpected(asked.error());
    asked->forecast = [&](double seconds) {
        console.err << fmt::format("Sun of {}: {}\n", countOf(asked->places.size(), "place"),
                                   describeForecast(seconds));
    };
    auto book = orCode(bookSettingsOf(options.sheets, sheetsOf(*request)), exitUsage);
    if (!book) return tl::make_unexpected(book.error());
    return orCode(byPlaceQuestion().compute(*asked, progress, interrupt.token()), exitFailed)
        .map([&](std::shared_ptr<const Answer> answer) {
            return MeasuredPlaces{std::move(answer), *std::move(book), request->project};
        });
}

Result<std::vector<std::filesystem::path>> writeFiles(const MeasuredPlaces& measured,
                                                      const ByPlaceOptions& options) {
    const OffscreenQt qt;
    const SunByPlace& sun = measured.answer->as<SunOfCities>()->baseline;
    AnswerFiles how;
    how.sheets = options.sheets.wanted;
    how.book = measured.book;
    how.legend = options.colours.legend;
    how.thresholdHours = options.colours.thresholdHours;
    how.rules = outputRulesOf(options.study, sun.provenance.inputs);
    auto files = measured.answer->write(sun.city, options.study.out, how);
    if (!files) return files;
    return copyProjectOf(measured.project, options.study).map([&] { return *std::move(files); });
}

std::string describeSun(const SunOfPlace& of) {
    if (of.cells == 0) return std::string(describe(of.status));
    return fmt::format("{:5.2f} h of sun a day ({:.2f} to {:.2f}), {:5.1f} % with enough", of.meanHours,
                       of.minHours, of.maxHours, 100 * of.enoughShare);
}

// What cells were measured: small places have their own.
std::string describeCells(const SunByPlace& sun) {
    const auto isFine = [&](const SunOfPlace& of) {
        return of.cells > 0 && of.cellM < sun.settings.study.receivers.cellM;
    };
    const auto fine = std::size_t(std::ranges::count_if(sun.sun, isFine));
    const std::string standard = fmt::format("{:g} m", sun.settings.study.receivers.cellM);
    if (fine == 0) return standard;
    return fmt::format("{}; {:g} m in {} with fewer than {:g} of these", standard, sun.settings.smallCellM,
                       countOf(fine, "place"), SunByPlaceSettings::smallPlaceCells);
}

std::string describeChange(const ComparedSun& compared, std::size_t i) {
    const SunChange& change = compared.changes[i];
    if (std::isnan(change.meanHours)) return {};
    return fmt::format("  {}: {} h, at most {:.0f} min less, {:.1f} % loses", compared.sun.name,
                       formatSigned(change.meanHours, 2), change.maxLossMin, 100 * change.lostShare);
}

std::string describeWithTrees(const SunByPlace& sun, std::size_t i) {
    std::string text;
    for (const SunWithTrees& with : sun.withTrees)
        if (!std::isnan(with.sun[i].meanHours))
            text += fmt::format("  {}: {:.2f} h", describeTrees(with.column), with.sun[i].meanHours);
    return text;
}

void printPlaces(const SunOfCities& all, std::ostream& out) {
    constexpr std::size_t maxListed = 40;
    const SunByPlace& sun = all.baseline;
    for (std::size_t i = 0; i < std::min(maxListed, sun.places.size()); ++i) {
        out << fmt::format("{:<44} {:<13} {}", sun.places[i].name, nameOf(sun.places[i].kind),
                           describeSun(sun.sun[i]))
            << describeWithTrees(sun, i);
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
    for (const ComparedSun& one : all.compared) {
        table.add("errors of", one.sun.name);
        addErrors(table, one.sun.errors);
    }
}

void printSun(const SunOfCities& all, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    const SunByPlace& sun = all.baseline;
    const AnswerPage page = makePage(all);
    out << formatText(page.headline) << ".\n";
    for (const Sentence& finding : page.findings) out << formatText(finding) << '\n';
    out << '\n';
    Table table;
    table.add("period", formatText(sun.settings.study.period));
    table.add("engine", sun.field.engine);
    if (!sun.treesHow.empty()) table.add("trees", sun.treesHow);
    table.add("places", withCommas(sun.places.size()));
    table.add("possible", fmt::format("{:.2f} h of sun a day without any shadow", sun.possibleHours));
    table.add("enough", fmt::format("{:g} h of sun a day", sun.settings.enoughHours));
    table.add("cells", describeCells(sun));
    if (sun.error) table.add("error of cells", describeCellError(sun.error));
    for (std::size_t date = 0; date < sun.dateErrors.size(); ++date)
        table.add("error, " + formatText(sun.settings.dates[date]), describeCellError(sun.dateErrors[date]));
    addErrors(table, sun.errors);
    addComparison(table, all);
    table.add("time", fmt::format("{:.2f} s, {} expected", sun.seconds.at("total"),
                                  describeForecast(sun.seconds.at("forecast"))));
    table.print(out);
    out << '\n';
    printPlaces(all, out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, sun.warnings);
}

int runByPlace(const ByPlaceOptions& options, const Console& console) {
    const auto measured = measurePlaces(options, console);
    if (!measured) return fail(console, measured.error().error, measured.error().code);
    const auto files = writeFiles(*measured, options);
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.study.json)
        console.out << measured->answer->json() << '\n';
    else
        printSun(*measured->answer->as<SunOfCities>(), *files, console.out);
    return exitOk;
}

void addScenarioOptions(CLI::App& command, ByPlaceOptions& options) {
    command
        .add_option(flags::scenario, options.scenarios,
                    "Scenario of the project to compare with the baseline; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command
        .add_option(flags::baseline, options.study.scenario,
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
    command->add_option(fromFlag, options->from, "Also the places of this file; may be repeated")
        ->allow_extra_args(false)
        ->type_name("FILE");
    command
        ->add_option(
            regionFlag, options->regions,
            "Also this region as a place, whatever its kind: a box in degrees, a file of polygons, or "
            "a region of the project; may be repeated")
        ->allow_extra_args(false)
        ->type_name("W,S,E,N|FILE|NAME");
    options->place.settings.sidewalkM = PlaceSettings::defaultSidewalkM;
    addPlaceOptions(*command, options->place);
    addFieldOptions(*command, sunByPlaceFields().of(options->settings));
    addCellOptions(*command, study.settings);
    addEngineOptions(*command, study.settings);
    addFieldOptions(*command, treeFields().of(study.settings));
    addErrorOptions(*command, study.settings.errorSample);
    addLegendOptions(*command, options->colours.legend);
    command
        ->add_option(flags::threshold, options->colours.thresholdHours,
                     "Hours of sun a day at which the map of the sheets and the style of places.gpkg change "
                     "their colour (default: --enough)")
        ->check(within(0, SunByPlaceSettings::maxHours))
        ->type_name("H");
    addSheetSwitch(*command, options->sheets);
    addSheetOptions(*command, options->sheets, {{"--date", "--sheet-date"}});
    command
        ->add_option(flags::out, study.out,
                     "Folder for places.csv, places_by_time.csv, places.gpkg, places.json and the maps")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(*command, study.overwrite);
    addProjectCopyOption(*command, study.withProject);
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
