#pragma once

#include <string>

#include "core/geo/frame.h"
#include "core/study/tiles/assemble_map.h"

namespace noonmark {

/// A GDAL virtual raster (VRT) that shows the tiles' files as one raster: NaN where there is none. Paths are
/// relative to `folder`, where it is to be stored. `runs`: with a band of continuous shadow.
std::string makeMosaic(const TilePlan& plan, const TileFiles& tiles, const Frame& frame, bool runs,
                       const std::filesystem::path& folder);

}  // namespace noonmark
