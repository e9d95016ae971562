#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geo/crs_to_lon_lat.h"
#include "core/geo/grid.h"
#include "core/io/read_part.h"
#include "core/io/terrain/raster_place.h"

namespace noonmark {

/// The posts that a terrain raster becomes, before their elevations are known.
struct TerrainGrid {
    Frame frame;
    PixelWindow window;  ///< the pixels that are used
    PostGrid posts;
    bool flipped = false;             ///< the posts' row 0 is the window's last; of posts that are kept
    std::optional<Grid> resampledTo;  ///< nothing: the posts are the window's pixels
    Ring border;                      ///< of the window, local metres
    TerrainSource source;
    Warnings warnings;
    [[nodiscard]] bool coarser() const { return source.method == TerrainMethod::averaged; }
};

/// The raster's own rows and columns as far as `settings.farAwayM` to each side of the frame's origin, each
/// post in its place (placePosts). Resampled to squares, with a warning, only where there would be more than
/// 64 million posts (then larger), or where no smooth map places them to within 1 cm or a fiftieth of a
/// pixel. A frame that is not given has the raster's middle as its origin. Error: no part of it lies there,
/// or its coordinates cannot be what its system says.
Result<TerrainGrid> makeTerrainGrid(const RasterPlace& raster, const CrsToLonLat& crs,
                                    const ReadSettings& settings, const std::string& file);

/// Puts elevations (metres above the datum, NaN where unknown; one a post) into the piece as its terrain.
/// Where the frame is not given, local z = 0 is the lowest elevation. The earth's curvature is taken off
/// (core/geo/earth_drop.h). Impossible elevations (beyond -500 to
/// 9000 m) and gaps are filled from the nearest post, and counted in a warning if they lie within the
/// raster's border. Error: no elevation at all.
Result<void> finishTerrain(const TerrainGrid& place, std::vector<float> elevations,
                           const ReadSettings& settings, const std::string& file, FilePiece& piece);

}  // namespace noonmark
