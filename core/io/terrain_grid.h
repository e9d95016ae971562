#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/geo/crs_to_lon_lat.h"
#include "core/io/read_part.h"
#include "core/receivers/grid.h"

namespace noonmark {

/// Where a raster lies, in its own coordinate reference system.
struct RasterPlace {
    std::vector<glm::dvec2> border;  ///< points along its four sides, in order round it
    glm::dvec2 middle{};             ///< and the places one pixel on from the middle:
    glm::dvec2 nextColumn{};
    glm::dvec2 nextRow{};
};

/// The grid in the project's plane that a terrain raster is resampled to.
struct TerrainGrid {
    Frame frame;
    Grid grid;
    Ring border;           ///< of the raster, local metres
    bool coarser = false;  ///< cells are larger than the raster's pixels
    Warnings warnings;
};

/// Cells as large as the raster's pixels, but 0.25 to 1000 m, and larger (with a warning) where there would
/// be more than 64 million. The grid covers the raster's box, as far as `settings.farAwayM` to each side of
/// the frame's origin. A frame that is not given has the raster's middle as its origin. Error: no part of it
/// lies there, or its coordinates cannot be what its system says.
Result<TerrainGrid> terrainGrid(const RasterPlace& raster, const CrsToLonLat& crs,
                                const ReadSettings& settings, const std::string& file);

/// Puts elevations (metres above the datum, NaN where unknown; grid order) into the piece as its terrain.
/// Where the frame is not given, local z = 0 is the lowest elevation. The earth's curvature is taken off
/// (core/geo/earth_drop.h). Impossible elevations (beyond -500 to
/// 9000 m) and gaps are filled from the nearest cell, and counted in a warning if they lie within the
/// raster's border. Error: no elevation at all.
Result<void> finishTerrain(const TerrainGrid& place, std::vector<float> elevations,
                           const ReadSettings& settings, const std::string& file, FilePiece& piece);

}  // namespace noonmark
