#pragma once

// The folder core/city/terrain is the ground of a city. Terrain (this file) holds elevations on a grid of
// posts (post_grid.h) and their origin, TerrainSource. It is made of rasters in core/io/terrain, or of
// triangles or points by tin_terrain.h; post_grid.h fills missing posts. building_ground.h tells where
// buildings touch the ground.

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/city/meshes/mesh.h"
#include "core/city/terrain/post_grid.h"

namespace noonmark {

/// How a terrain's posts were made from their source.
enum class TerrainMethod {
    asGiven,       ///< no source is known: made by a program, or by an older version of this one
    kept,          ///< the source's own rows and columns, each post in its place
    bilinear,      ///< resampled to another grid, bilinearly
    averaged,      ///< resampled to larger cells by averaging
    triangulated,  ///< a grid over the source's triangles
    fromBases,     ///< a grid over triangles between the bases of buildings
};

/// Origin of a terrain, and how far it may deviate from its source. Travels with the terrain into results and
/// project files, and does not affect shadows.
struct TerrainSource {
    TerrainMethod method = TerrainMethod::asGiven;
    std::string file;               ///< name without folder
    std::size_t sourceColumns = 0;  ///< of the whole raster; 0 if the source is not a raster
    std::size_t sourceRows = 0;
    std::size_t sourcePoints = 0;  ///< points of the triangles, or bases; 0 for a raster
    /// Side of a square as large as the raster's middle pixel; 0 if the source is not a raster
    double sourceCellM = 0;
    double misplacedM = 0;  ///< the largest distance of a kept post from its true position, metres
    /// Deviation of the surface from the source's own points, metres: root mean square and largest; 0 if
    /// kept.
    double heightRmsM = 0;
    double heightMaxM = 0;
    std::size_t filled = 0;      ///< posts without elevation in the source, filled from the posts around
    std::size_t impossible = 0;  ///< how many of them had an impossible elevation
    /// Posts of a surface model that showed buildings or trees and got the elevation of the ground around
    std::size_t underBuildings = 0;
    bool cut = false;  ///< areas far from the city were left out

    bool operator==(const TerrainSource&) const = default;
};

/// The ground as elevations of posts. Between posts it is the surface of meshOf's triangles, so that the
/// ground under buildings and the ground that casts shadows agree; beyond the outer posts the nearest value
/// holds.
struct Terrain {
    PostGrid grid;
    std::vector<float> elevationM;  ///< local z of each post; all finite
    TerrainSource source = {};

    bool operator==(const Terrain&) const = default;
};

/// Local z of the ground at a point, metres. Some 15 ns; 0.1 us where the posts' grid is bent.
float elevationAt(const Terrain& terrain, glm::dvec2 point);

/// Two triangles for each cell between posts, facing up: 2 (columns - 1)(rows - 1) triangles. A cell's
/// diagonal runs from its first corner to the one in the next column and row.
TriangleMesh meshOf(const Terrain& terrain);

}  // namespace noonmark
