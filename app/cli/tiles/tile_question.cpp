#include "app/cli/tiles/tile_question.h"

#include "app/cli/load_city.h"
#include "app/cli/project/project_question.h"
#include "core/receivers/roof_receivers.h"
#include "scenarios/impact/impact_tiles.h"
#include "scenarios/project/project_file.h"
#include "scenarios/weights/score_tiles.h"

namespace noonmark::cli {

namespace {

Result<TileQuestionRead> questionOfFiles(const TileStudyOptions& options) {
    const StudyOptions& study = options.study;
    if (!study.scenario.empty() || !study.periodName.empty() || !options.weights.empty())
        return failure("Only a project has scenarios, weights and periods by name", study.read.files.front(),
                       "Give one project file, NAME.noonmark.gpkg");
    if (study.period.start.empty())
        return failure("The start date is missing", "period", "Give --start DATE");
    return periodFrom(study.period).map([&](const Period& period) {
        TileQuestionRead question{study.settings, std::nullopt};
        question.settings.period = period;
        return question;
    });
}

Result<std::shared_ptr<const City>> sharedCity(const Project& project, const std::string& scenario) {
    return cityOf(project, scenario).map([](EditedCity edited) {
        return std::make_shared<const City>(std::move(edited.city));
    });
}

Result<void> checkComparable(const StudySettings& settings) {
    if (settings.byMonth)
        return failure("Months are those of a study", "--by month", "Leave out --baseline and --weights");
    return checkOnGround(settings.receivers.places);
}

Result<TileSubject> impactIn(const Project& project, const TileStudyOptions& options, ComparedCities cities) {
    auto before = sharedCity(project, options.baseline);
    if (!before) return tl::make_unexpected(before.error());
    cities.before = *std::move(before);
    return makeImpactSubject(cities);
}

Result<TileSubject> subjectIn(const Project& project, const TileStudyOptions& options) {
    const StudyOptions& study = options.study;
    const std::string scenario = study.scenario.empty() ? existingCity : study.scenario;
    const bool compares = !options.baseline.empty(), scores = !options.weights.empty();
    auto city = sharedCity(project, scenario);
    if (!city) return tl::make_unexpected(city.error());
    auto region = regionIn(project, compares || scores ? *project.city : **city, study.region);
    if (!region) return tl::make_unexpected(region.error());
    if (compares) return impactIn(project, options, {nullptr, *city, *region});
    if (!scores) return TileSubject{.key = "study", .cities = {*city}, .region = *region};
    return findWeights(project, options.weights).map([&](TimeWeights weights) {
        return makeScoreSubject({*city, *region, std::move(weights)});
    });
}

Result<TileQuestionRead> questionIn(const Project& project, const TileStudyOptions& options) {
    TileQuestionRead question{options.study.settings, std::nullopt};
    if (!listMaps(options).empty()) {
        if (auto may = checkComparable(question.settings); !may) return tl::make_unexpected(may.error());
        question.settings.errorSample.receivers = 0;
    }
    return periodIn(project, options.study.periodName, options.study.period)
        .and_then([&](const Period& period) {
            question.settings.period = period;
            return subjectIn(project, options);
        })
        .map([&](TileSubject subject) {
            question.subject = std::move(subject);
            return std::move(question);
        });
}

}  // namespace

Result<TileQuestionRead> readQuestion(const TileStudyOptions& options) {
    const ReadOptions& read = options.study.read;
    if (!namesProject(read)) return questionOfFiles(options);
    return checkProjectAlone(read)
        .and_then([&] { return ProjectFile::open(read.files.front()); })
        .and_then([&](const ProjectFile& disk) { return questionIn(disk.project(), options); });
}

Result<Period> readPeriod(const TileStudyOptions& options) {
    if (options.study.periodName.empty()) return periodFrom(options.study.period);
    return readQuestion(options).map(
        [](const TileQuestionRead& question) { return question.settings.period; });
}

std::vector<TileMap> listMaps(const TileStudyOptions& options) {
    if (!options.baseline.empty()) return listImpactMaps();
    if (!options.weights.empty()) return listScoreMaps();
    return {};
}

}  // namespace noonmark::cli
