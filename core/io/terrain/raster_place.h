#pragma once

// The folder core/io/terrain makes the ground of a city. read_terrain_gdal.cpp reads rasters: this file
// transforms pixels to local metres, chooses the posts and finishes the Terrain. ground_choice.h chooses
// among rasters and takes the ground from a model of the surface. buildings_on_terrain.h makes a terrain from
// the ground elevations that buildings state, and places one building on a terrain; standing.h places the
// buildings of files.

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/city/terrain/post_grid.h"
#include "core/geo/crs.h"
#include "core/geo/frame.h"
#include "core/geo/grid.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// The georeference of a raster in its own coordinate reference system. Pixel coordinates count from the
/// corner of the first pixel, row 0 is the raster's own first row; pixel centres lie at halves.
struct RasterPlace {
    int columns = 0;
    int rows = 0;
    std::array<double, 6> geoTransform{};  ///< as GDAL has it
    [[nodiscard]] glm::dvec2 at(glm::dvec2 pixel) const;
};

/// Transforms pixel coordinates of a raster to local metres. Holds references to its three arguments, which
/// must outlive it.
class PixelPlaces {
public:
    PixelPlaces(const RasterPlace& raster, const CrsToLonLat& crs, const Frame& frame)
        : raster_(raster), crs_(crs), frame_(frame) {}
    /// NaN for a pixel that cannot be transformed, or lies more than 1,000 km from the origin. Some 2 us
    /// each.
    [[nodiscard]] std::vector<glm::dvec2> local(const std::vector<glm::dvec2>& pixels) const;

private:
    const RasterPlace& raster_;
    const CrsToLonLat& crs_;
    const Frame& frame_;
};

/// A window of a raster.
struct PixelExtent {
    int column = 0, row = 0;  ///< the first pixel
    int columns = 0, rows = 0;
    [[nodiscard]] std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
    bool operator==(const PixelExtent&) const = default;
};

/// The pixels within `farAwayM` of the origin to each side, and few others. Nothing: there are none.
std::optional<PixelExtent> extentNear(const RasterPlace& raster, const PixelPlaces& places, double farAwayM);

/// The centres of a window's pixels as posts.
struct PlacedPosts {
    PostGrid posts;
    bool flipped = false;  ///< the posts' row 0 is the window's last
    /// The largest distance of a post from its true position, checked on 2,600 of them
    double misplacedM = 0;
};

/// Places the posts by steps alone if that is accurate to 1 mm, otherwise with a bend of the third degree.
/// The window must have at least two columns and two rows.
PlacedPosts placePosts(const PixelPlaces& places, const PixelExtent& window);

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
