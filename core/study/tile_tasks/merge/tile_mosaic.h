#pragma once

#include <string>

#include "core/geo/frame.h"
#include "core/study/tiles/assemble_map.h"

namespace noonmark {

/// A GDAL virtual raster (VRT) that shows a map in the tiles' files as one raster: NaN where there is none.
/// Paths are relative to `folder`, where it is to be stored.
std::string makeMosaic(const TilePlan& plan, const TileFiles& tiles, const Frame& frame, const TileMap& map,
                       const std::filesystem::path& folder);

}  // namespace noonmark
