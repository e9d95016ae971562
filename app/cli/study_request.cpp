#include "app/cli/study_request.h"

#include "app/cli/load_city.h"
#include "app/cli/project/project_question.h"
#include "app/input/all_engines.h"
#include "app/input/load_project.h"
#include "app/report/files/output_folder.h"
#include "core/base/stopwatch.h"
#include "core/io/read_region.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

Result<Region> regionFrom(const std::string& text, const City& city) {
    return text == "city" ? cityRegion(city) : readRegion(text, city.frame);
}

Result<Period> periodOfFiles(const StudyOptions& options) {
    if (options.period.start.empty() && options.periodName.empty())
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
    StudySettings settings = options.settings;
    const auto period = periodOfFiles(options);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto loaded = noonmark::loadCity(options.read.files, options.read.settings, progress, stop);
    if (!loaded) return tl::make_unexpected(loaded.error());
    auto region = regionFrom(options.region, loaded->read.city);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    return StudyRequest{*std::move(loaded), std::move(settings), std::nullopt};
}

Result<StudyRequest> requestOfProject(const StudyOptions& options) {
    const std::string& file = options.read.files.front();
    if (auto alone = checkProjectAlone(options.read); !alone) return tl::make_unexpected(alone.error());
    const Stopwatch watch;
    const auto disk = ProjectFile::open(file);
    if (!disk) return tl::make_unexpected(disk.error());
    const Project& project = disk->project();
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
    LoadedCity loaded = loadProjectCity(project, file);
    loaded.read.city = std::move(city->city);
    loaded.seconds = watch.seconds();
    Provenance provenance = provenanceOf(project, &*disk, {scenario, {}, settings.region, {}});
    return StudyRequest{std::move(loaded), std::move(settings), std::move(provenance)};
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

OutputRules outputRulesOf(const StudyOptions& options, const std::vector<InputFile>& inputs) {
    OutputRules rules = outputRules(options.read.files, inputs, options.overwrite);
    addPlace(rules, options.region);
    return rules;
}

tl::expected<StudyRequest, Failure> parseStudyRequest(const StudyOptions& options,
                                                      std::vector<std::string> files, Progress& progress,
                                                      const std::stop_token& stop) {
    if (auto may = orCode(checkBeforeReading(options, files), exitUsage); !may)
        return tl::make_unexpected(may.error());
    auto request = orCode(
        namesProject(options.read) ? requestOfProject(options) : requestOfFiles(options, progress, stop),
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

Provenance provenanceOf(const StudyRequest& request) {
    return request.provenance ? *request.provenance : provenanceOf(request.loaded);
}

void addSource(Study& study, const StudyRequest& request) {
    addReading(study, request.loaded);
    study.provenance = provenanceOf(request);
}

}  // namespace noonmark::cli
