#pragma once

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

enum class LengthUnit { metres, feet, usSurveyFeet, centimetres };
enum class UpAxis { z, y };

/// Whether buildings that state the ground they stand on make a terrain where none is read: where the relief
/// between neighbours matters (core/io/terrain/terrain_from_bases.h), always, or never (the ground is then
/// flat).
enum class TerrainFromBases { automatic, always, never };

/// How to read what a file does not say by itself. Every field has a default that is right for well-made
/// files.
struct ReadSettings {
    std::string heightField;               ///< empty: found by its name
    std::string levelsField;               ///< of storeys; empty: found by its name
    std::optional<LengthUnit> heightUnit;  ///< empty: metres unless the value or the field says otherwise
    double metresPerLevel = 3.2;           ///< 2 to 6
    double defaultHeightM = 9.6;           ///< for buildings without any height, 1 to 1000
    std::string layer;                     ///< empty: every polygon layer
    std::optional<std::string> crs;        ///< "EPSG:2263"; stated by the user where the file has none
    std::string lod;                       ///< CityJSON: "2.2"; empty: the highest that is there
    double farAwayM = 60000;  ///< what lies further from the middle of the data is left out (and said)

    TerrainFromBases terrainFromBases = TerrainFromBases::automatic;

    // Meshes (OBJ, PLY, glTF) know neither axes, unit nor place.
    UpAxis upAxis = UpAxis::y;
    LengthUnit meshUnit = LengthUnit::metres;
    double meshNorthDeg = 0;           ///< azimuth of the mesh's north axis from true north, clockwise
    std::optional<LonLat> meshAnchor;  ///< where the mesh's origin stands; needed for meshes alone

    std::optional<Frame> frame;  ///< join an existing project instead of choosing an origin
};

/// What a file gave: what could be read, and what could not.
struct CityRead {
    City city;
    Warnings warnings;
    std::string format;        ///< "OpenStreetMap PBF", for people
    std::size_t features = 0;  ///< read in all
    std::string attribution;   ///< of the data, where known ("(c) OpenStreetMap contributors")
    HeightFacts heights;       ///< the fields that heights were read from, and those that could be named
};

/// Reads one or more files into one city: footprints (GeoJSON, GeoPackage, Shapefile, OSM XML and PBF),
/// CityJSON and CityJSONSeq, meshes, terrain rasters. The format is known from the content, not only the
/// name. The first file that has a place fixes the frame. A feature that cannot be used is a warning; a file
/// that cannot be used at all is an Error.
Result<CityRead> readCity(const std::vector<std::filesystem::path>& files, const ReadSettings& settings,
                          Progress& progress, std::stop_token stop);

}  // namespace noonmark
