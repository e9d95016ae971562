#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/progress.h"
#include "core/geo/frame.h"
#include "core/io/files/file_tags.h"
#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_journal.h"

namespace noonmark {

/// The map of a tiled study.
struct MapFile {
    std::filesystem::path path;
    FileTags tags;
};

/// Writes one GeoTIFF with overviews from the finished tiles of a journal, NaN in empty ones; includes
/// continuous shadow if `runs`. Holds one tile in memory. Error: a tile that cannot be read, a map that
/// cannot be written; cancelled().
Result<void> assembleMap(const TilePlan& plan, const TileJournal& journal, const Frame& frame,
                         const MapFile& file, bool runs, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
