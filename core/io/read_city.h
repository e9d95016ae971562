#pragma once

// The folder core/io reads cities, terrains and regions, and writes cities and rasters. readCity() (this
// file) reads any number of files: it detects each file's format (formats/, files/), calls its reader
// (read_part.h: footprints/ and osm/, cityjson/, meshes/, terrain/), joins their pieces in one frame,
// and places buildings on the terrain. heights/ interprets attributes for all readers. read_region.h reads
// the region of a study, write_city.h and write_raster.h write GIS files. A file that uses a library has its
// name in the file name.

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/io/heights/height_facts.h"

namespace noonmark {

enum class LengthUnit { metres, feet, usSurveyFeet, centimetres, millimetres, inches, decimetres };
enum class UpAxis { z, y, automatic };

/// Whether to make a terrain from the ground elevations that buildings state, if no terrain is read: if the
/// relief between neighbours matters (core/io/terrain/terrain_from_bases.h), always, or never (the ground is
/// then flat).
enum class TerrainFromBases { automatic, always, never };

/// How buildings stand on a terrain: as their bases lie against it (core/io/terrain/standing.h), each set
/// down on it, or at the elevations that the files state.
enum class Stand { automatic, terrain, absolute };

/// What a terrain raster shows: found by whether it jumps at the outlines of buildings
/// (core/io/terrain/surface_model.h), the bare ground, or a surface with the buildings on it.
enum class TerrainShows { automatic, ground, surface };

/// Settings for what a file does not state itself. Every field has a default that is right for well-made
/// files.
struct ReadSettings {
    std::string heightField;               ///< empty: found by its name
    std::string levelsField;               ///< field with the number of storeys; empty: found by its name
    std::optional<LengthUnit> heightUnit;  ///< empty: metres unless the value or the field says otherwise
    double metresPerLevel = 3.2;           ///< 2 to 6
    double defaultHeightM = 9.6;           ///< for buildings without any height, 1 to 1000
    std::string layer;                     ///< empty: the polygon layers that hold buildings
    std::optional<std::string> crs;        ///< "EPSG:2263"; stated by the user for files that state none
    std::string lod;          ///< level of detail of CityJSON: "2.2"; empty: the highest available
    double farAwayM = 60000;  ///< features farther from the middle of the data are left out, with a warning

    TerrainFromBases terrainFromBases = TerrainFromBases::automatic;
    Stand stand = Stand::automatic;
    TerrainShows terrainShows = TerrainShows::automatic;
    bool heightsFromSurface = false;  ///< buildings without a height get that of the surface model

    // Meshes (OBJ, PLY, glTF) state neither axes, unit nor position.
    UpAxis upAxis = UpAxis::automatic;  ///< automatic: as the format says, or by the shape of the mesh
    LengthUnit meshUnit = LengthUnit::metres;
    double meshScale = 1;              ///< factor on all coordinates, over 0; of a proposal being read
    double meshNorthDeg = 0;           ///< azimuth of the mesh's north axis from true north, clockwise
    std::optional<LonLat> meshAnchor;  ///< position of the mesh's origin; needed if only meshes are read

    std::optional<Frame> frame;  ///< join an existing project instead of choosing an origin
};

/// The result of reading files.
struct CityRead {
    City
        city;  ///< its context: the water of OpenStreetMap's files, which is no ground; null if there is none
    Warnings warnings;
    std::string format;        ///< for display: "OpenStreetMap PBF"
    std::size_t features = 0;  ///< number of features read
    std::string attribution;   ///< of the data, if known ("(c) OpenStreetMap contributors")
    HeightFacts heights;       ///< where heights and bases were read from, and candidates to choose from
};

/// Reads one or more files into one city: footprints, 3D city models, meshes, terrain rasters
/// (formats/format.h lists them). The format is detected from the content, not only the name. The first file
/// with a position fixes the frame. A feature that cannot be used gives a warning; a file that cannot be used
/// at all gives an Error.
Result<CityRead> readCity(const std::vector<std::filesystem::path>& files, const ReadSettings& settings,
                          Progress& progress, std::stop_token stop);

}  // namespace noonmark
