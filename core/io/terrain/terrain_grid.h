#pragma once

// The folder core/io/terrain makes the ground of a city. read_terrain_gdal.cpp reads rasters: raster_place.h
// transforms pixels to local metres, terrain_grid.h (this file) chooses the posts and finishes the Terrain.
// ground_choice.h chooses among rasters and takes the ground from a model of the surface (surface_model.h).
// buildings_on_terrain.h makes a terrain from the ground elevations that buildings state, and places one
// building on a terrain; standing.h places the buildings of files.

#include <optional>
#include <string>
#include <vector>

#include "core/geo/crs.h"
#include "core/geo/grid.h"
#include "core/io/pieces/read_part.h"
#include "core/io/terrain/raster_place.h"

namespace noonmark {

/// The posts of a terrain raster, before their elevations are known.
struct TerrainGrid {
    Frame frame;
    PixelExtent window;  ///< the pixels in use
    PostGrid posts;
    /// The posts' row 0 is the window's last row; only for posts that are not resampled
    bool flipped = false;
    std::optional<Grid> resampledTo;  ///< nothing: the posts are the window's pixels
    Ring border;                      ///< border of the window, local metres
    TerrainSource source;
    Warnings warnings;
    [[nodiscard]] bool coarser() const { return source.method == TerrainMethod::averaged; }
};

/// The raster's own rows and columns up to `settings.farAwayM` to each side of the frame's origin, each post
/// in its place (placePosts). Resampled to squares, with a warning, only if there would be more than 64
/// million posts (then the squares are larger), or if no smooth map places them to within 1 cm or a fiftieth
/// of a pixel. Without a given frame the origin is the middle of the raster. Error: no part of the raster
/// lies there, or its coordinates cannot belong to its system.
Result<TerrainGrid> makeTerrainGrid(const RasterPlace& raster, const CrsToLonLat& crs,
                                    const ReadSettings& settings, const std::string& file);

/// Makes the terrain of the piece from elevations (metres above the datum, NaN if unknown; one per post).
/// Without a given frame, local z = 0 is the lowest elevation. Elevations are lowered by the earth's
/// curvature (core/geo/frame.h). Impossible elevations (beyond -500 to 9000 m) and gaps are filled from
/// the nearest post, and counted in a warning if they lie within the raster's border. Error: no elevations at
/// all.
Result<void> finishTerrain(const TerrainGrid& place, std::vector<float> elevations,
                           const ReadSettings& settings, const std::string& file, FilePiece& piece);

}  // namespace noonmark
