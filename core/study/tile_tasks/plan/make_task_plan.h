#pragma once

#include <stop_token>

#include "core/study/study.h"
#include "core/study/tile_tasks/plan/pack_tasks.h"
#include "core/study/tile_tasks/plan/task_plan.h"
#include "core/study/tile_tasks/plan/tile_subject.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark {

struct TaskPlanRequest {
    std::vector<std::string> files;  ///< absolute paths
    ReadSettings reading;
    StudySettings settings;  ///< its region is not used
    std::string region;      ///< "city", "W,S,E,N" or a polygon file
    int tileCells = TiledStudySettings::defaultTileCells;
    TaskSize task{};
    /// A study that is wider or higher is divided into districts of about this side, metres: far from the
    /// middle of a district its sun is off by 0.009 degrees per km.
    double districtM = 40000;
    bool builtUpOnly = false;  ///< leave out tiles without a building
    /// Measured instead of the city in `files`; they are then not read, and `region` is not used
    const TileSubject* subject = nullptr;
    const TimelineRequest* timelines = nullptr;  ///< as in TaskQuestion
    const ByPlaceRequest* byPlace = nullptr;     ///< likewise

    [[nodiscard]] TaskQuestion question() const { return {reading, settings, subject, timelines, byPlace}; }
};

/// Files that have to be read whole by every task may not be larger than this together.
inline constexpr std::uintmax_t maxBytesReadWhole = 2'000'000'000;

/// Plans a study in tiles. Footprints in FlatGeobuf, or in a GeoPackage or Shapefile with a spatial index,
/// are read in one pass and then window by window, so that memory does not grow with the country; a terrain
/// is read for each district. Of several files, every task reads only those that its windows touch, whole if
/// they have no index: so a country may be a folder of CityJSON. One file of another format is read whole,
/// here and by every task. Of timelines and sun by place, only tiles with places are planned, and their halo
/// is that of their places; with the region "city", sun by place takes all places, wherever they lie. The
/// study's own errors, those of readPlaces(), and: files that are too large to be read whole; a terrain from
/// bases, which needs the whole city.
/// `arguments` and `inputs` of the plan are the caller's.
Result<TaskPlan> makeTaskPlan(const TaskPlanRequest& request, Progress& progress, const std::stop_token& stop,
                              const EngineList& engines = coreEngines());

/// How a task reads the files of a plan: by the frame of its district and, if the plan says so, by window.
ReadSettings readSettingsIn(const District& district, ReadSettings reading);

}  // namespace noonmark
