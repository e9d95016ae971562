#pragma once

#include <stop_token>

#include "core/study/study.h"
#include "core/study/tile_tasks/plan/task_plan.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark {

/// What a task may take.
struct TaskSize {
    double seconds = 300;      ///< a task ends when the next tile would exceed it; one tile may
    double memoryBytes = 2e9;  ///< a window ends when the next tile would exceed it; one tile may
};

/// Gives every tile its task and its window, and sorts the tiles by them. Tiles are taken along a
/// space-filling curve (Z-order) of their district. A task runs until its time is used up. It reads its tiles
/// window by window, one after the other: a window is the union of its tiles' halos and ends where that union
/// needs too much memory. Without `plan.byExtent` files are read whole, so that a task has one window. Tasks
/// are numbered from 0; none mixes districts. Returns the number of tasks.
std::size_t packTasks(TaskPlan& plan, const TaskSize& size);

/// The estimated peak of the task that needs the most memory: of its largest window. 0 without tiles.
double largestExtentBytes(const TaskPlan& plan);

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
