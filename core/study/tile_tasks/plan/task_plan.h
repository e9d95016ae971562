#pragma once

// The folder core/study/tile_tasks divides a study of any size among the tasks of a scheduler. In plan/, a
// TaskPlan (this file) lists districts, tiles and tasks. make_task_plan.h makes it from the city's files, or
// from a TileSubject, and says which task runs a tile: find_districts.h divides the region into districts,
// tile_load.h surveys their buildings and says what a tile has to read and how long it takes. run_task.h
// computes one task with the runner and the journal of core/study/tiles, and sums up what is done.
// merge/merge_tiles.h joins the maps of the tiles, their timelines and their sun by place.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"
#include "core/receivers/receivers.h"
#include "core/receivers/tile_plan.h"
#include "core/study/provenance/provenance.h"
#include "core/study/tiles/by_place_measure.h"
#include "core/study/tiles/timeline_measure.h"

namespace noonmark {

/// What a plan of tiles is about if it is not the shadow of a city that tasks read from its files: scenarios
/// of a project. The caller reads them, whole, for the plan and for every task.
struct TileSubject {
    /// Says what is measured of which cities. A part of the hashes of plan and tiles, which otherwise tell
    /// apart only all buildings together.
    std::string key;
    /// The cities, with one frame and one terrain: the shadow of all of them counts. The sun is that of the
    /// last one.
    std::vector<std::shared_ptr<const City>> cities;
    Region region;      ///< of the study, in their frame
    double fields = 1;  ///< shadow fields that a tile costs
    /// Null: the shadow of the last city. The measure may hold references to the cities.
    std::function<std::unique_ptr<TileMeasure>(const TileQuestion&)> measure;
};

/// What a plan was made for; its tasks get the same.
struct TaskQuestion {
    ReadSettings reading;
    StudySettings settings;                ///< without region
    const TileSubject* subject = nullptr;  ///< null: the files of the plan
    /// Not null: the timelines of places instead, of the last city of the subject, and compared with its
    /// first city if it has two
    const TimelineRequest* timelines = nullptr;
    /// Not null: sun by place instead, of these cities
    const ByPlaceRequest* byPlace = nullptr;

    /// The places that are measured instead of cells; null: cells are.
    [[nodiscard]] const PlacesRequest* places() const {
        return byPlace != nullptr ? static_cast<const PlacesRequest*>(byPlace) : timelines;
    }
};

/// Identifies settings, subject, timelines and sun by place. The region of the settings is not counted.
std::string hashQuestion(const TaskQuestion& question);

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
