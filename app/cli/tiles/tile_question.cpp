#include "app/cli/tiles/tile_question.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <filesystem>

#include "app/cli/options/field_options.h"
#include "app/cli/study/study_request.h"
#include "core/describe/command_options.h"
#include "core/receivers/place_names.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/study_fields.h"
#include "scenarios/project/project_file.h"
#include "scenarios/tile_subjects.h"

namespace noonmark::cli {

std::vector<std::string> listArguments(const CLI::App& command, const std::vector<std::string>& leaveOut) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || !name.starts_with("--")) continue;
        if (std::ranges::find(leaveOut, name) != leaveOut.end()) continue;
        if (option->get_items_expected_max() == 0) {
            words.push_back(name);
            continue;
        }
        for (const std::string& value : option->results()) words.push_back(fmt::format("{}={}", name, value));
    }
    return words;
}

namespace {

// Sidewalks as by-place has them, where none are stated.
void addByPlaceOptions(CLI::App& command, TileStudyOptions& options) {
    CLI::Option* byPlace =
        command
            .add_option("--by-place", options.byPlace,
                        "Measure the sun of the places of this file (polygons, or OpenStreetMap) or, of a "
                        "project, of its own places: the project")
            ->excludes(command.get_option(flags::weights))
            ->excludes(command.get_option("--timelines"))
            ->excludes(command.get_option("--by"))
            ->type_name("FILE");
    const std::vector<CLI::Option*> before = command.get_options();
    addFieldOptions(command, sunByPlaceFields().of(options.sun));
    for (CLI::Option* option : command.get_options())
        if (std::ranges::find(before, option) == before.end()) option->needs(byPlace);
    const CLI::Option* sidewalks = command.get_option("--sidewalks");
    command.parse_complete_callback([&options, byPlace, sidewalks] {
        if (byPlace->count() > 0 && sidewalks->count() == 0)
            options.places.settings.sidewalkM = PlaceSettings::defaultSidewalkM;
    });
}

}  // namespace

void addTileStudyOptions(CLI::App& command, TileStudyOptions& options) {
    addStudyOptions(command, options.study);
    addMonthOption(command, options.study.settings);
    addFieldOptions(command, treeFields().of(options.study.settings));
    CLI::Option* baseline =
        command
            .add_option("--baseline", options.baseline,
                        "Measure the impact of the project's --scenario: the scenario to compare it with")
            ->needs(command.get_option(flags::scenario))
            ->type_name("NAME");
    CLI::Option* weights = command
                               .add_option(flags::weights, options.weights,
                                           "Measure the shadow score: a time-weight table of the project")
                               ->excludes(baseline)
                               ->type_name("NAME");
    CLI::Option* timelines =
        command
            .add_option("--timelines", options.timelines,
                        "Measure the timelines of the places of this file (polygons, or OpenStreetMap)")
            ->excludes(weights)
            ->excludes(command.get_option("--by"))
            ->type_name("FILE");
    command.add_flag("--all-steps", options.allSteps, "Of timelines of several days, state the steps too")
        ->needs(timelines);
    addPlaceOptions(command, options.places);
    addByPlaceOptions(command, options);
}

Result<TileStudyOptions> parseArguments(const std::vector<std::string>& arguments,
                                        const std::vector<std::string>& files) {
    CLI::App parser;
    TileStudyOptions options;
    addTileStudyOptions(parser, options);
    std::vector<std::string> words{"city", "--out=folder"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::ranges::reverse(words);  // the parser takes them from the back
    try {
        parser.parse(words);
    } catch (const CLI::ParseError& error) {
        return failure(std::string("The options of the plan cannot be used: ") + error.what(), "plan.json",
                       "Plan again with this version");
    }
    options.study.read.files = files;
    return options;
}

namespace {

Result<TileQuestionRead> questionOfFiles(const TileStudyOptions& options) {
    const StudyOptions& study = options.study;
    if (!study.scenario.empty() || !study.periodName.empty() || !options.weights.empty())
        return failure("Only a project has scenarios, weights and periods by name", study.read.files.front(),
                       "Give one project file, NAME.noonmark.gpkg");
    if (!study.period.states("--start"))
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

Result<TileSubject> scoreIn(const Project& project, const TileStudyOptions& options, ComparedCities cities) {
    return findWeights(project, options.weights).map([&](TimeWeights weights) {
        return makeScoreSubject({cities.after, cities.region, std::move(weights)});
    });
}

/// A question besides the shadow of a scenario that tiles of a project answer.
struct TiledQuestion {
    std::string TileStudyOptions::*askedBy;  ///< the option that asks it
    std::vector<TileMap> (*maps)(const LegendChoice&);
    /// Takes the scenario and the region; the baseline is read where it counts.
    Result<TileSubject> (*subject)(const Project&, const TileStudyOptions&, ComparedCities);
};
constexpr std::array tiledQuestions{TiledQuestion{&TileStudyOptions::baseline, listImpactMaps, impactIn},
                                    TiledQuestion{&TileStudyOptions::weights, listScoreMaps, scoreIn}};

// Null: the shadow of a scenario.
const TiledQuestion* findQuestion(const TileStudyOptions& options) {
    if (!options.byPlace.empty()) return nullptr;
    const auto asked = std::ranges::find_if(
        tiledQuestions, [&](const TiledQuestion& one) { return !(options.*one.askedBy).empty(); });
    return asked == tiledQuestions.end() ? nullptr : &*asked;
}

// The cities to measure places in: the baseline first, where there is one.
Result<TileSubject> placesIn(const Project& project, const TileStudyOptions& options,
                             std::shared_ptr<const City> city, Region region) {
    TileSubject subject{.key = "timelines;" + hashCity(*city), .region = std::move(region)};
    if (!options.baseline.empty()) {
        auto before = sharedCity(project, options.baseline);
        if (!before) return tl::make_unexpected(before.error());
        subject.key += ';' + hashCity(**before);
        subject.cities.push_back(*std::move(before));
    }
    subject.cities.push_back(std::move(city));
    subject.fields = double(subject.cities.size());
    return subject;
}

Result<TileSubject> subjectIn(const Project& project, const TileStudyOptions& options) {
    const StudyOptions& study = options.study;
    const std::string scenario = study.scenario.empty() ? existingCity : study.scenario;
    const TiledQuestion* const question = findQuestion(options);
    auto city = sharedCity(project, scenario);
    if (!city) return tl::make_unexpected(city.error());
    auto region = regionIn(project, question != nullptr ? *project.city : **city, study.region);
    if (!region) return tl::make_unexpected(region.error());
    if (!options.placesFile().empty())
        return placesIn(project, options, *std::move(city), *std::move(region));
    if (question != nullptr) return question->subject(project, options, {nullptr, *city, *region});
    return TileSubject{.key = "study", .cities = {*city}, .region = *region};
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

TimelineLabels labelsOf(const TileStudyOptions& options, Zone zone) {
    const std::string& scenario = options.study.scenario;
    const std::string city = scenario.empty() ? existingCity : scenario;
    if (options.baseline.empty()) return {city, {}, std::move(zone)};
    return {options.baseline, city, std::move(zone)};
}

void setPlaces(PlacesRequest& request, const TileStudyOptions& options, const InputFile& file) {
    request.places = options.placesFile();
    request.reading = options.places.settings;
    request.placesHash = file.sha256;
}

Result<TileQuestionRead> addTimelines(TileQuestionRead question, const TileStudyOptions& options,
                                      const InputFile& file) {
    question.settings.errorSample.receivers = 0;
    return Zone::named(question.settings.period.zone).map([&](Zone zone) {
        TimelineRequest& timelines = question.timelines.emplace();
        setPlaces(timelines, options, file);
        timelines.allSteps = options.allSteps;
        timelines.labels = labelsOf(options, std::move(zone));
        return std::move(question);
    });
}

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error);
}

// Of a project all its places of the kinds asked for, and their box where the whole city is asked for.
Result<void> takeOwnPlaces(TileQuestionRead& question, const TileStudyOptions& options) {
    const ReadOptions& read = options.study.read;
    ByPlaceRequest& byPlace = *question.byPlace;
    NoProgress quiet;
    if (namesProject(read) && isSameFile(read.files.front(), options.byPlace)) {
        const auto file = ProjectFile::open(options.byPlace);
        if (!file) return tl::make_unexpected(file.error());
        for (const Place& place : file->project().places)
            if (options.places.admits(place)) byPlace.own.push_back(place);
        if (byPlace.own.empty())
            return failure("The project has no such place", options.byPlace,
                           "Add places: noonmark-cli project place read");
    }
    if (!question.subject || options.study.region != "city") return {};
    const auto places = readPlaces(byPlace, question.subject->cities.back()->frame, quiet, {});
    if (!places) return tl::make_unexpected(places.error());
    const Box2 box = bounds(*places);
    if (!box.empty()) question.subject->region = makeRegionFromLocalBox(box);
    return {};
}

Result<TileQuestionRead> addByPlace(TileQuestionRead question, const TileStudyOptions& options,
                                    const InputFile& file) {
    ByPlaceRequest& byPlace = question.byPlace.emplace();
    setPlaces(byPlace, options, file);
    byPlace.settings = options.sun;
    const std::string& scenario = options.study.scenario;
    byPlace.cities = {scenario.empty() ? existingCity : scenario};
    if (!options.baseline.empty()) byPlace.cities.insert(byPlace.cities.begin(), options.baseline);
    return takeOwnPlaces(question, options).map([&] { return std::move(question); });
}

Result<TileQuestionRead> addPlaces(TileQuestionRead question, const TileStudyOptions& options) {
    auto ground = checkOnGround(question.settings.receivers.places);
    if (!ground) return tl::make_unexpected(ground.error());
    const auto file = describeInputFile(options.placesFile());
    if (!file) return tl::make_unexpected(file.error());
    return options.byPlace.empty() ? addTimelines(std::move(question), options, *file)
                                   : addByPlace(std::move(question), options, *file);
}

}  // namespace

Result<TileQuestionRead> readQuestion(const TileStudyOptions& options) {
    const ReadOptions& read = options.study.read;
    auto question =
        namesProject(read)
            ? checkProjectAlone(read)
                  .and_then([&] { return ProjectFile::open(read.files.front()); })
                  .and_then([&](const ProjectFile& disk) { return questionIn(disk.project(), options); })
            : questionOfFiles(options);
    if (!question || options.placesFile().empty()) return question;
    return addPlaces(*std::move(question), options);
}

Result<Period> readPeriod(const TileStudyOptions& options) {
    if (options.study.periodName.empty()) return periodFrom(options.study.period);
    return readQuestion(options).map(
        [](const TileQuestionRead& question) { return question.settings.period; });
}

std::vector<TileMap> listMaps(const TileStudyOptions& options, const LegendChoice& legend) {
    const TiledQuestion* const question = findQuestion(options);
    return question != nullptr ? question->maps(legend) : std::vector<TileMap>();
}

}  // namespace noonmark::cli
