#pragma once

// The folder core/io/settings says how files are read: ReadSettings and advice that names a setting (this
// file); the table of its fields and its text in projects.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/describe/field.h"
#include "core/geo/frame.h"
#include "core/geo/lon_lat.h"

namespace noonmark {

enum class LengthUnit { metres, feet, usSurveyFeet, centimetres, millimetres, inches, decimetres };
enum class UpAxis { z, y, automatic };

/// A unit of lengths in data.
struct LengthUnitEntry {
    LengthUnit unit;
    std::string_view key;     ///< as options take it: "us-ft"
    std::string_view name;    ///< for people: "US survey ft"
    std::string_view plural;  ///< "US survey feet"
    double metres;
};

/// All units, in the order of LengthUnit.
std::span<const LengthUnitEntry> listLengthUnits();

const LengthUnitEntry& entryOf(LengthUnit unit);
inline double metresPer(LengthUnit unit) { return entryOf(unit).metres; }

/// Whether to make a terrain from the ground elevations that buildings state, if no terrain is read: if the
/// relief between neighbours matters (core/io/terrain/buildings_on_terrain.h), always, or never (the ground
/// is then flat).
enum class TerrainFromBases { automatic, always, never };

/// How buildings stand on a terrain: as their bases lie against it (core/io/terrain/standing.h), each set
/// down on it, or at the elevations that the files state.
enum class Stand { automatic, terrain, absolute };

/// What a terrain raster shows: found by whether it jumps at the outlines of buildings
/// (core/io/terrain/ground_choice.h), the bare ground, or a surface with the buildings on it.
enum class TerrainShows { automatic, ground, surface };

/// Settings for what a file does not state itself. Every field has a default that is right for well-made
/// files.
struct ReadSettings {
    std::string heightField;               ///< empty: found by its name
    std::string levelsField;               ///< field with the number of storeys; empty: found by its name
    std::string nameField;                 ///< field with the buildings' names; empty: found by its name
    std::optional<LengthUnit> heightUnit;  ///< empty: metres unless the value or the field says otherwise
    double metresPerLevel = 3.2;           ///< 2 to 6
    double defaultHeightM = 9.6;           ///< for buildings without any height, 1 to 1000
    std::string layer;                     ///< empty: the polygon layers that hold buildings
    std::optional<std::string> crs;        ///< "EPSG:2263"; stated by the user for files that state none
    std::string lod;          ///< level of detail of CityJSON: "2.2"; empty: the highest available
    double farAwayM = 60000;  ///< features farther from the middle of the data are left out, with a warning
    std::optional<LonLatBox> extent;  ///< only buildings that touch it are read; terrain stays whole

    TerrainFromBases terrainFromBases = TerrainFromBases::automatic;
    Stand stand = Stand::automatic;
    TerrainShows terrainShows = TerrainShows::automatic;
    bool heightsFromSurface = false;  ///< buildings without a height get that of the surface model
    /// Buildings that are made of a surface model follow its cells to within this height, 0.05 to 5 m.
    double surfaceToleranceM = 0.5;

    std::vector<std::string> treeFiles;  ///< inventories of trees beside those of the city's files

    // Meshes (OBJ, PLY, glTF) state neither axes, unit nor position.
    UpAxis upAxis = UpAxis::automatic;  ///< automatic: as the format says, or by the shape of the mesh
    LengthUnit meshUnit = LengthUnit::metres;
    double meshScale = 1;              ///< factor on all coordinates, over 0; of a proposal being read
    double meshNorthDeg = 0;           ///< azimuth of the mesh's north axis from true north, clockwise
    std::optional<LonLat> meshAnchor;  ///< position of the mesh's origin; needed if only meshes are read

    std::optional<Frame> frame;  ///< join an existing project instead of choosing an origin
};

/// Advice for files that do not state their position on earth, or state an impossible one. All readers use
/// the same wording, so that the window can recognise it and offer the setting.
std::string crsAdvice();
std::string anchorAdvice();

/// Whether stating ReadSettings::crs or ReadSettings::meshAnchor could resolve the error: its advice is, or
/// begins with, one of the two above.
[[nodiscard]] bool asksForPlace(const Error& error);

/// All settings of reading a city but the frame, which no user sets; the two tables below are part of it.
const Fields<ReadSettings>& readSettingsFields();

/// Where buildings stand: also of a proposal being read.
const Fields<ReadSettings>& standFields();

/// The axis and the unit of a mesh's coordinates: also of a proposal being read.
const Fields<ReadSettings>& meshAxesFields();

/// How a user states the field with this key on the command line, for messages: "--stand absolute".
std::string readOption(std::string_view key, std::string_view value = {});

/// The settings that differ from the defaults of ReadSettings, as JSON on one line; empty if none do. `frame`
/// is omitted: it belongs to the open city.
std::string formatText(const ReadSettings& reading);

/// Parses the output of formatText(); nothing for other text.
std::optional<ReadSettings> readSettingsFrom(const std::string& text);

}  // namespace noonmark
