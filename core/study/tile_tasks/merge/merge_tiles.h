#pragma once

#include <map>
#include <optional>
#include <stop_token>

#include "core/io/places/read_places.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/task_status.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

struct MergeSettings {
    std::optional<std::filesystem::path> places;  ///< a polygon layer, for statistics by place
    PlaceSettings placeSettings{};
    bool partial = false;     ///< also merge a plan that is not complete; cells of missing tiles are NaN
    Provenance provenance{};  ///< written into the maps and tables
    /// Of a plan with a TileSubject that has its own measure; empty: those of a study
    std::vector<TileMap> maps{};
    LegendChoice legend{};  ///< of the styles of maps of shadow
};

/// What merging wrote.
struct MergeReport {
    std::vector<std::filesystem::path> files;
    ShadowStatistics statistics;            ///< of all districts
    std::map<std::string, double> figures;  ///< sums of the measure's own figures
    std::size_t places = 0;                 ///< of timelines
    std::size_t missingTiles = 0;
    Warnings warnings{};  ///< those of timelines are in their files
};

/// The folder `merged` of a plan, made if it is missing.
Result<std::filesystem::path> makeMergedFolder(const std::filesystem::path& plan);

/// Joins the finished tiles of a plan, into the folder `merged` of the plan, for each district: `shadow.tif`,
/// a Cloud Optimized GeoTIFF; `shadow.vrt`, a virtual raster over the tiles' own files; `shadow.qml`, the
/// style of both for QGIS; `item.json`, a STAC item; if the settings ask for months, `by_month.tif`,
/// `by_month.vrt`, `by_month.qml` and `by_month.csv`; and for all districts together `statistics.json` and,
/// if places are given, `places.csv`. Other measures have maps of other names, and a table of places for each
/// map with shadow (`before_places.csv`). Names of districts are put before those of the files. Cells equal
/// those of the tiles to the last bit. Existing files of an earlier merge are replaced. Holds one tile in
/// memory. Error: tiles are missing, a file cannot be read or written, places of maps without shadow;
/// cancelled().
Result<MergeReport> mergeTiles(const std::filesystem::path& folder, const TaskPlan& plan,
                               const StudySettings& settings, const MergeSettings& merge, Progress& progress,
                               const std::stop_token& stop);

}  // namespace noonmark
