#pragma once

#include <filesystem>
#include <stop_token>
#include <string>

#include "core/base/result.h"
#include "core/geo/frame.h"
#include "core/measures/statistics.h"
#include "core/study/study.h"
#include "core/study/tile_tasks/plan/task_plan.h"
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

}  // namespace noonmark
