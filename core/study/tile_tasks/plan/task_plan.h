#pragma once

// The folder core/study/tile_tasks divides a study of any size among the tasks of a scheduler. In plan/, a
// TaskPlan (this file) lists districts, tiles and tasks. make_task_plan.h makes it from the city's files, or
// from a TileSubject (tile_subject.h), and says which task runs a tile: find_districts.h divides the region
// into districts, survey_district.h surveys their buildings, and tile_load.h says what a tile has to read and
// how long it takes. run_task.h computes one task with the runner and the journal of core/study/tiles, and
// task_status.h sums up what is done. In merge/, merge_tiles.h joins the maps of the tiles (map_files.h),
// merge_timelines.h their timelines and merge_by_place.h their sun by place.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"
#include "core/receivers/region.h"
#include "core/receivers/tile_plan.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// A part of a study with one frame, one grid and one sun, small enough for all three to hold everywhere in
/// it. A city is one district.
struct District {
    std::string name;  ///< of files: "" if it is the only one, else "d-003-"
    Frame frame;
    Region region;
    TilePlan tiles;
    std::string terrainHash;  ///< empty without terrain
};

/// A tile of a district, and what it takes to compute it.
struct PlannedTile {
    std::size_t district = 0;
    std::size_t number = 0;  ///< in the district's TilePlan
    Box2 halo;               ///< contains every occluder whose shadow can reach the tile
    Box2 reads;              ///< the halo, and all of each building that touches it
    std::string contentHash;
    std::size_t buildings = 0;  ///< within `reads`
    double seconds = 0;         ///< estimated, on two cores
    double memoryBytes = 0;     ///< estimated peak of a process that runs only this tile
    double readBytes = 0;       ///< of it, for what lies within `reads`
    std::size_t task = 0;
    std::size_t window = 0;  ///< of its task, from 0: the tiles of a window are read together
};

/// Everything that a task needs to know: it is stored in plan.json.
struct TaskPlan {
    std::vector<std::string> files;      ///< absolute paths, as the study names them
    std::vector<LonLatBox> fileBoxes;    ///< around each of `files`; tasks open only what they need
    std::vector<std::string> arguments;  ///< options of the study, for the parser that made the plan
    std::vector<InputFile> inputs;       ///< with their hashes
    std::string settingsHash;            ///< hashSettings() without a region
    bool byExtent = false;               ///< tasks read only the window that they need
    std::vector<District> districts;
    std::vector<PlannedTile> tiles;  ///< in the order of their tasks, and in them of their windows
    std::size_t taskCount = 0;

    /// Identifies the journal of a district's tiles.
    [[nodiscard]] std::string studyHash(std::size_t district) const;
    /// The tiles of a task, all of one district, as a range of `tiles`.
    [[nodiscard]] std::vector<PlannedTile> tilesOf(std::size_t task) const;
};

inline constexpr const char* planFileName = "plan.json";
inline constexpr const char* indexFileName = "tiles.gpkg";

/// The folder of a task's journal and tiles.
std::filesystem::path taskFolder(const std::filesystem::path& plan, std::size_t task);

/// Writes plan.json. The same plan is read back, to the last bit.
Result<void> writeTaskPlan(const std::filesystem::path& folder, const TaskPlan& plan);
/// Error: there is none, it is damaged, or of another version.
Result<TaskPlan> readTaskPlan(const std::filesystem::path& folder);

/// Writes the index as a GeoPackage for maps: layers `tiles` and `halos`, in longitude and latitude. Backend:
/// tile_index_gdal.cpp.
Result<void> writeTileIndex(const std::filesystem::path& file, const TaskPlan& plan);

}  // namespace noonmark
