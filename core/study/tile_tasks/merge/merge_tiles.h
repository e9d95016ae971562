#pragma once

#include <optional>
#include <stop_token>

#include "core/io/places/read_places.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/task_status.h"

namespace noonmark {

struct MergeSettings {
    std::optional<std::filesystem::path> places;  ///< a polygon layer, for statistics by place
    PlaceSettings placeSettings{};
    bool partial = false;  ///< also merge a plan that is not complete; cells of missing tiles are NaN
    FileTags tags{};       ///< of the maps
};

/// What merging wrote.
struct MergeReport {
    std::vector<std::filesystem::path> files;
    ShadowStatistics statistics;  ///< of all districts
    std::size_t missingTiles = 0;
};

/// Joins the finished tiles of a plan, into the folder `merged` of the plan, for each district: `shadow.tif`,
/// a Cloud Optimized GeoTIFF; `shadow.vrt`, a virtual raster over the tiles' own files; `item.json`, a STAC
/// item; and for all districts together `statistics.json` and, if places are given, `places.csv`. Names of
/// districts are put before those of the files. Cells equal those of the tiles to the last bit. Existing
/// files of an earlier merge are replaced. Holds one tile in memory. Error: tiles are missing, a file cannot
/// be read or written; cancelled().
Result<MergeReport> mergeTiles(const std::filesystem::path& folder, const TaskPlan& plan,
                               const StudySettings& settings, const MergeSettings& merge, Progress& progress,
                               const std::stop_token& stop);

}  // namespace noonmark
