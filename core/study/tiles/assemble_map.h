#pragma once

#include <filesystem>
#include <stop_token>

#include "core/base/progress.h"
#include "core/geo/frame.h"
#include "core/io/files/file_tags.h"
#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_journal.h"

namespace noonmark {

/// The map that a tiled study writes.
struct MapFile {
    std::filesystem::path path;
    FileTags tags;
};

/// One GeoTIFF with overviews from the finished tiles of a journal, NaN in empty ones; continuous shadow is
/// in it with `runs`. Holds one tile in memory. Error: a tile that can't be read, a map that can't be
/// written; cancelled().
Result<void> assembleMap(const TilePlan& plan, const TileJournal& journal, const Frame& frame,
                         const MapFile& file, bool runs, Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
