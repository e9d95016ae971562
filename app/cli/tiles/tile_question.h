#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/project_options.h"
#include "app/cli/options/study_options.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/tile_tasks/plan/task_plan.h"

namespace noonmark::cli {

/// The options of a study in tiles, as given by the user.
struct TileStudyOptions {
    StudyOptions study;
    std::string baseline;    ///< scenario to compare with; empty: no comparison
    std::string weights;     ///< time-weight table; empty: no score
    std::string timelines;   ///< file of places to measure; empty: no timelines
    std::string byPlace;     ///< file of places to measure the sun of; empty: no sun by place
    PlaceOptions places;     ///< of that file
    bool allSteps = false;   ///< of timelines of several days
    SunByPlaceSettings sun;  ///< of sun by place

    /// The file of places that are measured instead of cells; empty: cells are.
    [[nodiscard]] const std::string& placesFile() const { return byPlace.empty() ? timelines : byPlace; }
};

/// Adds the options of every study, and those that say what is measured in tiles.
void addTileStudyOptions(CLI::App& command, TileStudyOptions& options);

/// The options of a parsed command that were given, as words that parse to the same values; without files and
/// without the options in `leaveOut`.
std::vector<std::string> listArguments(const CLI::App& command, const std::vector<std::string>& leaveOut);

/// Parses the words of listArguments(). `files`: of the study. Error: words of another version of the
/// program.
Result<TileStudyOptions> parseArguments(const std::vector<std::string>& arguments,
                                        const std::vector<std::string>& files);

/// What the options of a study in tiles ask for.
struct TileQuestionRead {
    StudySettings settings;              ///< with the period, without region
    std::optional<TileSubject> subject;  ///< of a project: a scenario, its impact or its score
    std::optional<TimelineRequest> timelines{};
    std::optional<ByPlaceRequest> byPlace{};

    [[nodiscard]] const TileSubject* subjectOrNull() const { return subject ? &*subject : nullptr; }
    [[nodiscard]] const TimelineRequest* timelinesOrNull() const { return timelines ? &*timelines : nullptr; }
    [[nodiscard]] const ByPlaceRequest* byPlaceOrNull() const { return byPlace ? &*byPlace : nullptr; }
};

/// Reads the project, if the files are one. Error: scenarios, periods by name or weights without a project;
/// the project cannot be read, or lacks what the options name; months or roofs of an impact, a score or
/// timelines; the file of places cannot be read.
Result<TileQuestionRead> readQuestion(const TileStudyOptions& options);

/// The period alone; reads the project only if it is a period by name.
Result<Period> readPeriod(const TileStudyOptions& options);

/// The maps of the tiles of an impact or a score; none for a study.
std::vector<TileMap> listMaps(const TileStudyOptions& options, const LegendChoice& legend = {});

}  // namespace noonmark::cli
