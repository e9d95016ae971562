#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/io/places/read_places.h"
#include "core/measures/statistics.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/plan/task_plan.h"
#include "core/study/tile_tasks/run_task.h"
#include "core/study/tiles/by_place_measure.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

/// Writes a Cloud Optimized GeoTIFF with the bands, cells, names and tags of a GeoTIFF that Noonmark wrote:
/// blocks of 512, DEFLATE, overviews of means. Error: it cannot be written; cancelled(). Backend:
/// map_files_gdal.cpp.
Result<void> writeCloudMap(const std::filesystem::path& from, const std::filesystem::path& to,
                           const std::stop_token& stop);

/// A STAC item (SpatioTemporal Asset Catalog 1.0.0, with the projection extension) for the maps of a
/// district: its outline in degrees, the first and last instant of the period, and its files as assets, with
/// paths relative to the item.
std::string makeStacItem(const TaskPlan& plan, const District& district, const std::vector<TileMap>& maps,
                         const SunSteps& sun, const Period& period, const ShadowStatistics& statistics);

/// A GDAL virtual raster (VRT) that shows a map in the tiles' files as one raster: NaN where there is none.
/// Paths are relative to `folder`, where it is to be stored.
std::string makeMosaic(const TilePlan& plan, const TileFiles& tiles, const Frame& frame, const TileMap& map,
                       const std::filesystem::path& folder);

struct MergeSettings {
    std::optional<std::filesystem::path> places;  ///< a polygon layer, for statistics by place
    PlaceSettings placeSettings{};
    bool partial = false;     ///< also merge a plan that is not complete; cells of missing tiles are NaN
    Provenance provenance{};  ///< written into the maps and tables
    /// The maps of a TileSubject that has its own measure; empty: those of a study
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

/// Joins the finished tiles of a plan of timelines, into the folder `merged` of the plan: `timelines.jsonl`,
/// a line of JSON for each place as of timelineJson(), and `timelines.csv`, a row for each place and day:
/// place, kind, source, day, area_m2, sunlit_min, theoretical_m2h, full_cover_min, all_sun_taken_min, and
/// enters, exits, duration_min, largest_m2, largest_at, area_hours_m2h, longest_stay_min of each kind of
/// shadow (baseline_enters, ...); of the baseline alone where there is no scenario. A place that lies at the
/// edge of two districts is taken from the first. Existing files of an earlier merge are replaced. Holds one
/// tile in memory. Error: tiles are missing, unless `partial`; a file cannot be read or written; cancelled().
Result<MergeReport> mergeTimelines(const std::filesystem::path& folder, const TaskPlan& plan, bool partial,
                                   Progress& progress, const std::stop_token& stop);

/// The sun of all places of a plan.
struct MergedSun {
    SunOfCities sun;  ///< without fields and cells; provenance and how places were chosen are the caller's
    std::size_t missingTiles = 0;
};

/// Joins the finished tiles of a plan of sun by place into the answer that compareSunByPlace() gives to all
/// places at once: the same figures, but for rounding, under the same engine, with places in the order in
/// which they are read. Errors are means by the values compared, and the largest of the tiles. `study`: the
/// settings that were planned for, without region. `cities`: as many as the request names, of which only the
/// ground is needed; `city` of the answer. A place that lies at the edge of two districts is taken from the
/// first; those of further districts are in the frame of the first. Error: tiles are missing, unless
/// `partial`: their places are then left out, with a warning; a file cannot be read; cancelled().
Result<MergedSun> mergeSunByPlace(const std::filesystem::path& folder, const TaskPlan& plan,
                                  const ByPlaceRequest& request, const StudySettings& study,
                                  const std::vector<City>& cities, bool partial, Progress& progress,
                                  const std::stop_token& stop);

}  // namespace noonmark
