#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/city/trees/tree_facts.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"
#include "core/io/heights/height_facts.h"
#include "core/io/heights/height_reading.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// A tree as a file has it.
struct ReadTree {
    LonLat place;
    TreeFacts facts;
};

/// The warning about areas that are read as canopy.
inline constexpr std::string_view woodIsClosedCanopy =
    NM_TEXT("a wood is taken as closed canopy, in columns of 8 x 8 m");

/// Covers a polygon, the outer ring and then holes, closed or not, with canopy: a column with these facts for
/// each square of 8 x 8 m whose middle lies in it, of larger squares where these would be more than 100,000.
/// O(area).
void coverWithCanopy(const std::vector<std::vector<LonLat>>& rings, const TreeFacts& facts,
                     std::vector<ReadTree>& trees);

/// The result of one reader for one file, in the frame that was given or that it chose. readCity() joins
/// these pieces.
struct FilePiece {
    std::optional<Frame> frame;  ///< set if the reader chose it
    std::vector<std::shared_ptr<const Building>> buildings;
    /// Local z of the ground that each building stands on, as the file states it; nothing if it does not, so
    /// that readCity() places the building on the terrain. One for each building.
    std::vector<std::optional<float>> groundM;
    /// Elevations of roofs that are all that the data have of a height: readCity() takes the height above the
    /// terrain. One for each building; empty if there is none.
    std::vector<std::optional<RoofElevation>> roofs;
    /// z counts from a zero of the file's own, of unknown elevation, and not from that of the frame (meshes).
    bool ownZero = false;
    std::vector<ReadTree> trees;
    std::shared_ptr<const Terrain> terrain;
    /// Of the terrain's posts those that the file has no elevation of, 1 each; empty if it has all.
    std::vector<char> unknownPosts;
    Warnings warnings;
    std::string format;
    std::size_t features = 0;
    std::string attribution;
    HeightFacts heights;
    /// The coordinate reference system and who says so: "Amersfoort / RD New, as the file states"; empty
    /// where the reader knows none.
    std::string crs;
};

/// Who says which coordinate reference system a file is in; for FilePiece::crs.
enum class CrsSource {
    file,     ///< the file, or its format
    user,     ///< ReadSettings::crs
    guessed,  ///< from the numbers
};
std::string describeCrs(const std::string& name, CrsSource source);  ///< defined in read_part.cpp

/// What a mesh says that was read without the position of its origin.
inline constexpr std::string_view originAsAnchor = "the project's origin is used as the mesh's origin";

/// What is assumed of UTM eastings of 1,000 km and more (CrsToLonLat::hasRemovedZoneNumber).
inline constexpr std::string_view zoneNumberRemoved =
    NM_TEXT("the eastings begin with the number of their zone, which was taken off");

/// One reader per family of formats (core_formats.cpp); OpenStreetMap has osm/read_osm_buildings.h.
/// `settings.frame` is set if an earlier file fixed it; otherwise the reader chooses the middle of its data.
/// `window`: null for the whole file.
Result<FilePiece> readFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                 Progress& progress, std::stop_token stop,
                                 const LonLatBox* window = nullptr);  ///< defined in read_footprints_gdal.cpp
Result<FilePiece> readCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                               Progress& progress,
                               std::stop_token stop);  ///< defined in cityjson_buildings.cpp
Result<FilePiece> readCityGml(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress,
                              std::stop_token stop);  ///< defined in citygml_load.cpp
Result<FilePiece> readArchive(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress, std::stop_token stop,
                              const LonLatBox* window = nullptr);  ///< defined in unpack_archive.cpp
Result<FilePiece> readMesh(const std::filesystem::path& file, const ReadSettings& settings,
                           Progress& progress,
                           std::stop_token stop);  ///< defined in mesh_buildings.cpp
Result<FilePiece> readTerrain(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress,
                              std::stop_token stop);  ///< defined in read_terrain_gdal.cpp

/// Removes, with one warning each, the buildings of a piece whose geometry is implausible: higher than 2,000
/// m, more than 20 km below or above all ground, more than 1,000 km from the frame's origin, not finite.
/// Readers of attributes check heights themselves and have other values to use; a mesh has nothing but its
/// shape. Error: this applied to all buildings, as happens if the unit is not the metre. O(vertices).
Result<void> leaveOutImplausible(const std::string& file, FilePiece& piece);

/// Leaves the buildings out whose box in longitude and latitude does not touch the extent, with one warning.
void keepExtent(const std::string& file, FilePiece& piece, const Frame& frame, const LonLatBox& extent);

/// Readers that read an extent alone read this much around it: the parts of buildings on its border.
inline constexpr double aroundExtentM = 500;

/// How the warnings of such buildings begin.
inline constexpr std::string_view secondBuilding = "a second building of the same ";

/// A building that is in the city twice, as positions in the list.
struct SameBuilding {
    std::size_t kept = 0, dropped = 0;
    bool byId = false;  ///< both have the same id; otherwise the same outline
};

/// Finds buildings that are there twice: two of the same id that are equally high and share more than half of
/// the smaller outline, or any two whose outlines share at least 95 % of the larger and that overlap over
/// half of the lower one's height. Kept is the one whose heights are better known (stated before storeys,
/// those before assumed), then the higher one, then the first. Of three the best one stays. Each is dropped
/// once at most. O(n log n).
std::vector<SameBuilding> findSameBuildings(const std::vector<std::shared_ptr<const Building>>& buildings);

}  // namespace noonmark
