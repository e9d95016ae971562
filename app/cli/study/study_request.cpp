#include "app/cli/study/study_request.h"

#include <algorithm>
#include <filesystem>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/input/all_engines.h"
#include "app/input/load_project.h"
#include "app/questions/review_question.h"
#include "app/report/files/output_folder.h"
#include "core/base/progress.h"
#include "core/io/elements/read_point_file.h"
#include "core/io/read_region.h"
#include "core/io/settings/read_settings.h"
#include "core/receivers/place_names.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

Result<LoadedCity> projectCity(const std::string& file) {
    return ProjectFile::open(file).map(
        [&](const ProjectFile& disk) { return loadProjectCity(disk.project(), file); });
}

}  // namespace

bool namesProject(const ReadOptions& options) { return std::ranges::any_of(options.files, isProjectFile); }

Result<void> checkProjectAlone(const ReadOptions& options) {
    const std::string& file = options.files.front();
    if (options.files.size() > 1)
        return failure("A project cannot be combined with other files", file, "Give only the project file");
    if (formatText(options.settings).empty()) return {};
    return failure("The city of a project has already been read: reading options have no effect", file,
                   "Omit them, or create a new project from the files with these options");
}

Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console) {
    if (namesProject(options))
        return checkProjectAlone(options).and_then([&] { return projectCity(options.files.front()); });
    const Interrupt interrupt;
    ProgressLine progress(console);
    return noonmark::loadCity(options.files, options.settings, progress, interrupt.token());
}

namespace {

// A place of an OpenStreetMap file by its name, where the text is no box, polygon or file. The error names
// places that are spelled alike.
Result<Region> regionOfPlace(const std::string& name, const std::vector<std::string>& files, const City& city,
                             Error drawn, Progress& progress, const std::stop_token& stop) {
    const auto read = loadCityPlaces(files, {.streets = true, .unnamed = false}, city.frame, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    if (read->places.empty()) return tl::make_unexpected(std::move(drawn));
    return findPlace(read->places, name).map([](const Place& place) { return regionOf(place); });
}

Result<Region> regionFrom(const StudyOptions& options, const City& city, Progress& progress,
                          const std::stop_token& stop) {
    const std::string& text = options.region;
    if (text == "city") return cityRegion(city);
    auto drawn = readRegion(text, city.frame);
    std::error_code ignored;
    const bool mayBeName = text.find_first_of(",(") == text.npos && !std::filesystem::exists(text, ignored);
    if (drawn || !mayBeName) return drawn;
    return regionOfPlace(text, options.read.files, city, drawn.error(), progress, stop);
}

Result<ElementSettings> readPointsOf(const StudyOptions& options) {
    ElementSettings elements = options.elements;
    if (options.points != ElementPlaces::points || elements.pointsFile.empty()) return elements;
    auto points = readPointFile(elements.pointsFile);
    if (!points) return tl::make_unexpected(points.error());
    elements.points = *std::move(points);
    return elements;
}

// Places of an OpenStreetMap file are read only where faces look at one.
Result<ElementSettings> elementsOfFiles(const StudyOptions& options, const City& city, Progress& progress,
                                        const std::stop_token& stop) {
    auto elements = readPointsOf(options);
    if (!elements) return elements;
    PlacesRead read;
    if (!elements->faces.place.empty()) {
        auto places = loadCityPlaces(options.read.files, {.streets = true, .unnamed = false}, city.frame,
                                     progress, stop);
        if (!places) return tl::make_unexpected(places.error());
        read = *std::move(places);
    }
    return findElementParts(*std::move(elements), read.places, options.read.settings, city);
}

Result<Period> periodOfFiles(const StudyOptions& options) {
    if (!options.period.states("--start") && options.periodName.empty())
        return failure("The start date is missing", "period", "Give --start DATE");
    if (options.periodName.empty()) return periodFrom(options.period);
    return failure("Only a project has periods by name", "--period " + options.periodName,
                   "Give --start DATE, or a project file");
}

Result<StudyRequest> requestOfFiles(const StudyOptions& options, Progress& progress,
                                    const std::stop_token& stop) {
    if (!options.scenario.empty())
        return failure("Only a project has scenarios", "--scenario " + options.scenario,
                       "Give one project file, NAME.noonmark.gpkg");
    if (options.withProject)
        return failure("There is no project to put beside the files", "--with-project",
                       "Give one project file, NAME.noonmark.gpkg");
    StudySettings settings = options.settings;
    const auto period = periodOfFiles(options);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto loaded = noonmark::loadCity(options.read.files, options.read.settings, progress, stop);
    if (!loaded) return tl::make_unexpected(loaded.error());
    auto region = regionFrom(options, loaded->read.city, progress, stop);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    auto elements = elementsOfFiles(options, loaded->read.city, progress, stop);
    if (!elements) return tl::make_unexpected(elements.error());
    return StudyRequest{*std::move(loaded), std::move(settings), *std::move(elements), std::nullopt};
}

Result<StudyRequest> requestOfProject(const StudyOptions& options, Progress& progress,
                                      const std::stop_token& stop) {
    const std::string& file = options.read.files.front();
    if (auto alone = checkProjectAlone(options.read); !alone) return tl::make_unexpected(alone.error());
    const Stopwatch watch;
    auto disk = ProjectFile::open(file);
    if (!disk) return tl::make_unexpected(disk.error());
    if (options.withProject)
        if (const auto may = checkCopy(*disk, options.out); !may) return tl::make_unexpected(may.error());
    Warnings photographs;
    const Project project = withLoadedPhotograph(disk->project(), photographs, progress, stop);
    const std::string scenario = options.scenario.empty() ? existingCity : options.scenario;
    auto city = cityOf(project, scenario);
    if (!city) return tl::make_unexpected(city.error());
    StudySettings settings = options.settings;
    const auto period = periodIn(project, options.periodName, options.period);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto region = regionIn(project, city->city, options.region);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    auto elements = readPointsOf(options).and_then(
        [&](ElementSettings read) { return findElementParts(std::move(read), project, city->city); });
    if (!elements) return tl::make_unexpected(elements.error());
    LoadedCity loaded = loadProjectCity(project, file);
    loaded.read.city = std::move(city->city);
    loaded.read.warnings.insert(loaded.read.warnings.end(), photographs.begin(), photographs.end());
    loaded.seconds = watch.seconds();
    Provenance provenance = provenanceOf(project, &*disk, {scenario, {}, settings.region, {}});
    return StudyRequest{std::move(loaded), std::move(settings), *std::move(elements), std::move(provenance),
                        std::make_shared<const ProjectFile>(*std::move(disk))};
}

Result<void> checkBeforeReading(const StudyOptions& options, const std::vector<std::string>& files) {
    const StudySettings& settings = options.settings;
    return makeEngine(settings.engine, settings.engineSettings, enginesWith(settings.engine))
        .and_then([&](const auto&) { return checkOutputs(options.out, files, outputRulesOf(options, {})); });
}

bool needsRegionFile(const StudyRequest& request) {
    const Region& region = request.settings.region;
    return (request.provenance ? request.provenance->region
                               : formatRegion(region, request.loaded.read.city)) == regionFileName;
}

}  // namespace

SheetSettings sheetsOf(const StudyRequest& request) {
    return request.project ? request.project->project().sheets : SheetSettings();
}

OutputRules outputRulesOf(const StudyOptions& options, const std::vector<InputFile>& inputs) {
    OutputRules rules = outputRules(listNamedFiles(options.read), inputs, options.overwrite);
    addPlace(rules, options.region);
    const ElementSettings& elements = options.elements;
    for (const std::string& file : {elements.windows.string(), elements.pointsFile.string(), elements.parcel})
        if (!file.empty()) addPlace(rules, file);
    return rules;
}

tl::expected<StudyRequest, Failure> parseStudyRequest(const StudyOptions& options,
                                                      std::vector<std::string> files, Progress& progress,
                                                      const std::stop_token& stop) {
    if (auto may = orCode(checkBeforeReading(options, files), exitUsage); !may)
        return tl::make_unexpected(may.error());
    auto request = orCode(namesProject(options.read) ? requestOfProject(options, progress, stop)
                                                     : requestOfFiles(options, progress, stop),
                          exitUsage);
    if (!request) return request;
    if (needsRegionFile(*request)) files.emplace_back(regionFileName);
    const OutputRules rules = outputRulesOf(options, request->loaded.inputs);
    if (auto may = orCode(checkOutputs(options.out, files, rules), exitUsage); !may)
        return tl::make_unexpected(may.error());
    if (auto folder = orCode(prepareFolder(options.out), exitFailed); !folder)
        return tl::make_unexpected(folder.error());
    return request;
}

Result<void> copyProjectOf(const std::shared_ptr<const ProjectFile>& project, const StudyOptions& options) {
    return options.withProject && project ? copyProject(*project, options.out) : Result<void>();
}

Provenance provenanceOf(const StudyRequest& request) {
    return request.provenance ? *request.provenance : provenanceOf(request.loaded);
}

void addSource(Study& study, const StudyRequest& request) {
    addReading(study, request.loaded);
    study.provenance = provenanceOf(request);
}

}  // namespace noonmark::cli
