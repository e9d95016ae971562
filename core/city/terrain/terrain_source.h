#pragma once

#include <cstddef>
#include <string>

namespace noonmark {

/// How a terrain's posts came from its source.
enum class TerrainMethod {
    asGiven,       ///< nothing is known of a source: made by a program, or by an older version of this one
    kept,          ///< the source's own rows and columns, each post in its place
    bilinear,      ///< resampled to another grid, bilinearly
    averaged,      ///< resampled to larger cells by their mean
    triangulated,  ///< a grid over the source's triangles
    fromBases,     ///< a grid over triangles between the bases of buildings
};

/// Where a terrain comes from and how far it may be from it: travels with the terrain into results and
/// project files, and changes no shadow.
struct TerrainSource {
    TerrainMethod method = TerrainMethod::asGiven;
    std::string file;               ///< name without folder
    std::size_t sourceColumns = 0;  ///< of the whole raster; 0 where the source is no raster
    std::size_t sourceRows = 0;
    std::size_t sourcePoints = 0;  ///< of triangles, or bases; 0 for a raster
    double sourceCellM = 0;        ///< side of a square as large as its middle pixel; 0 where it has none
    double misplacedM = 0;         ///< the largest distance of a kept post from its true place, metres
    /// Of the surface from the source's own points, metres: root mean square and largest; 0 where kept.
    double heightRmsM = 0;
    double heightMaxM = 0;
    std::size_t filled = 0;      ///< posts without elevation in the source, given the nearest one's
    std::size_t impossible = 0;  ///< of these, posts that had an impossible elevation
    bool cut = false;            ///< far from the city, left out

    bool operator==(const TerrainSource&) const = default;
};

}  // namespace noonmark
