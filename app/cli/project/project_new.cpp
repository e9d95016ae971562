#include <fmt/format.h>
#include <memory>
#include <ostream>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/project/project_commands.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_city.h"
#include "app/input/load_project.h"
#include "core/base/safe_text.h"
#include "core/city/trees/tree.h"
#include "core/io/read_region.h"
#include "core/receivers/made_names.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

struct NewOptions {
    std::string file;
    ReadOptions read;
    std::vector<std::string> regions;  // NAME=W,S,E,N or NAME=FILE
    std::vector<std::string> lots;
    bool noPlaces = false;
    bool noContext = false;
    bool streets = false;
    bool overwrite = false;
};

// Parses "Park=park.geojson" as a region of that name.
Result<Region> placeFrom(const std::string& text, const Frame& frame) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return failure("A place needs a name", text, "Give NAME=west,south,east,north or NAME=FILE");
    return readRegion(text.substr(equals + 1), frame).map([&](Region region) {
        region.name = text.substr(0, equals);
        return region;
    });
}

Result<void> addRegions(Project& project, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        auto region = placeFrom(text, project.city->frame);
        if (!region) return tl::make_unexpected(region.error());
        project.regions.push_back(*std::move(region));
    }
    return {};
}

// Each polygon becomes a lot.
Result<void> addLots(Project& project, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        const auto place = placeFrom(text, project.city->frame);
        if (!place) return tl::make_unexpected(place.error());
        for (std::size_t i = 0; i < place->polygons.size(); ++i)
            project.lots.push_back({numberName(place->name, i + 1), place->polygons[i]});
    }
    return {};
}

Result<Project> projectFrom(const NewOptions& options, const LoadedCity& loaded) {
    Project project = projectOf(loaded);
    return addRegions(project, options.regions)
        .and_then([&] { return addLots(project, options.lots); })
        .map([&] { return std::move(project); });
}

// The places of OpenStreetMap's files.
Result<PlacesRead> placesOf(const NewOptions& options, const Frame& frame, const Console& console) {
    if (options.noPlaces) return PlacesRead{};
    const Interrupt interrupt;
    ProgressLine progress(console);
    return loadCityPlaces(options.read.files, {.streets = options.streets, .wholeStreets = false}, frame,
                          progress, interrupt.token());
}

/// What OpenStreetMap's files draw on the ground.
Result<ContextRead> contextOf(const NewOptions& options, const Frame& frame, const Console& console) {
    if (options.noContext) return ContextRead{};
    const Interrupt interrupt;
    ProgressLine progress(console);
    return loadCityContext(options.read.files, frame, progress, interrupt.token());
}

// Protects the city's files and those of the places: "Park=park.geojson".
OutputRules rulesOf(const NewOptions& options) {
    OutputRules rules = outputRules(listNamedFiles(options.read), {}, options.overwrite);
    for (const auto* places : {&options.regions, &options.lots})
        for (const std::string& place : *places) addPlace(rules, place.substr(place.find('=') + 1));
    return rules;
}

int runNew(const NewOptions& options, const Console& console) {
    if (const auto may = checkOutput(options.file, OutputKind::project, rulesOf(options)); !may)
        return fail(console, may.error(), exitUsage);
    const auto loaded = loadCity(options.read, console);
    if (!loaded) return fail(console, loaded.error(), exitUsage);
    auto project = projectFrom(options, *loaded);
    if (!project) return fail(console, project.error(), exitUsage);
    auto places = placesOf(options, project->city->frame, console);
    if (!places) return fail(console, places.error(), exitUsage);
    project->places = std::move(places->places);
    auto context = contextOf(options, project->city->frame, console);
    if (!context) return fail(console, context.error(), exitUsage);
    City city = *project->city;
    city.context = joinContext(nullptr, std::move(context->context));
    project->city = std::make_shared<const City>(std::move(city));
    const auto made = ProjectFile::create(
        options.file, *project,
        options.overwrite ? ProjectFile::IfExists::replace : ProjectFile::IfExists::refuse);
    if (!made) return fail(console, made.error(), exitFailed);
    const std::size_t trees = project->city->trees ? project->city->trees->trees.size() : 0;
    console.out << fmt::format(
        "{}: {}, {}{}, {}, {}\n", options.file, countOf(project->city->buildings.size(), "building"),
        trees > 0 ? countOf(trees, "tree") + ", " : "", countOf(project->places.size(), "place"),
        countOf(project->regions.size(), "region"), countOf(project->lots.size(), "lot"));
    printWarnings(console.out, loaded->read.warnings);
    printWarnings(console.out, places->warnings);
    printWarnings(console.out, context->warnings);
    return exitOk;
}

}  // namespace

void addProjectNew(CLI::App& project, Run& run) {
    const auto options = std::make_shared<NewOptions>();
    CLI::App* command = project.add_subcommand("new", "Create a project from a city");
    command->add_option("project", options->file, "The project file to create")
        ->required()
        ->type_name("NAME.noonmark.gpkg");
    addReadOptions(*command, options->read);
    command->add_option("--region", options->regions, "Region where shadow is measured; may be repeated")
        ->type_name("NAME=W,S,E,N|FILE");
    command->add_option("--lot", options->lots, "Lot to build on; may be repeated")
        ->type_name("NAME=W,S,E,N|FILE");
    CLI::Option* without =
        command->add_flag("--no-places", options->noPlaces, "Do not read the places of OpenStreetMap files");
    command->add_flag("--no-context", options->noContext,
                      "Do not read the streets, parks and water that are drawn on the ground");
    command->add_flag("--streets", options->streets, "Read streets as places too")->excludes(without);
    command->add_flag(
        "--overwrite,--replace", options->overwrite,
        "Replace the project of this name with all its scenarios; never an input or another file");
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runNew(*options, console); }; });
}

void addProjectCommand(CLI::App& app, Run& run) {
    CLI::App* project = app.add_subcommand(
        "project",
        "Create and change a project: a city with its scenarios, lots, regions and places in one file");
    project->require_subcommand(1);
    addProjectNew(*project, run);
    addProjectInfo(*project, run);
    addProjectScenarios(*project, run);
    addProjectDemolish(*project, run);
    addProjectReplace(*project, run);
    addProjectHeight(*project, run);
    addProjectMove(*project, run);
    addProjectRotate(*project, run);
    addProjectImport(*project, run);
    addProjectExtrude(*project, run);
    addProjectVariant(*project, run);
    addProjectLot(*project, run);
    addProjectRegion(*project, run);
    addProjectPlace(*project, run);
    addProjectPeriod(*project, run);
    addProjectTree(*project, run);
    addProjectContext(*project, run);
    addProjectPhotograph(*project, run);
    addProjectWeights(*project, run);
    addProjectSheets(*project, run);
    addProjectResult(*project, run);
    addProjectExport(*project, run);
    addProjectShadows(*project, run);
    addProjectAnimate(*project, run);
    project->footer(
        "A first project:\n"
        "  noonmark-cli project new park.noonmark.gpkg sample:central-park-south\n"
        "  noonmark-cli project add-scenario park.noonmark.gpkg \"Without One57\"\n"
        "  noonmark-cli project demolish park.noonmark.gpkg One57 --scenario \"Without One57\"\n"
        "  noonmark-cli impact park.noonmark.gpkg --from \"Without One57\" --to Existing --region Park \\\n"
        "    --start 2026-11-01 --days 61 --at 08:00 --hours 8 --zone America/New_York --out out");
}

}  // namespace noonmark::cli
