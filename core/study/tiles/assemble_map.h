#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>

#include "core/base/progress.h"
#include "core/geo/frame.h"
#include "core/io/files/file_tags.h"
#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_journal.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

/// The map of a tiled study.
struct MapFile {
    std::filesystem::path path;
    FileTags tags;
    bool overviews = true;
};

/// The raster files of finished tiles by tile number; no path for a tile without a receiver.
using TileFiles = std::map<std::size_t, std::optional<std::filesystem::path>>;
TileFiles listFiles(const TileJournal& journal);

/// Writes the bands of one map into a GeoTIFF, from the files of finished tiles, NaN in empty and missing
/// ones, with overviews if the file asks for them. Holds one tile in memory. Error: a tile that
/// cannot be read, a map that cannot be written; cancelled().
Result<void> assembleMap(const TilePlan& plan, const TileFiles& tiles, const Frame& frame,
                         const MapFile& file, const TileMap& map, Progress& progress,
                         const std::stop_token& stop);

}  // namespace noonmark
