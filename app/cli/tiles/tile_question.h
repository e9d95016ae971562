#pragma once

#include <optional>

#include "app/cli/tiles/study_arguments.h"
#include "core/study/tile_tasks/plan/tile_subject.h"

namespace noonmark::cli {

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
