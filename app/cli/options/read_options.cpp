#include "app/cli/options/read_options.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/options/lon_lat_option.h"
#include "app/cli/options/number_range.h"
#include "core/io/heights/height_text.h"

namespace noonmark::cli {

namespace {

/// The words of an option and what each stands for, in the order in which help lists them.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// An option that takes one of these words.
template <class Value, class Target>
CLI::Option* addChoice(CLI::App& command, const std::string& name, Target& target,
                       const Choices<Value>& choices, const std::string& help) {
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) words.push_back(word);
    const auto take = [&target, choices](const std::string& word) {
        target = std::ranges::find(choices, word, &std::pair<std::string, Value>::first)->second;
    };
    return command.add_option_function<std::string>(name, take, help)->check(CLI::IsMember(words));
}

template <class Target>
void addUnit(CLI::App& command, const std::string& name, Target& target, const std::string& help) {
    Choices<LengthUnit> units;
    for (const LengthUnitEntry& entry : listLengthUnits()) units.emplace_back(entry.key, entry.unit);
    addChoice(command, name, target, units, help)->type_name("UNIT");
}

void addHeightOptions(CLI::App& command, ReadSettings& settings) {
    command
        .add_option("--height-field", settings.heightField,
                    "Field with the heights (default: found by its name)")
        ->type_name("NAME");
    command
        .add_option("--levels-field", settings.levelsField,
                    "Field with the storeys above the ground (default: found by its name)")
        ->type_name("NAME");
    addUnit(command, "--height-unit", settings.heightUnit,
            "Unit of numbers without a unit in it: m, ft, us-ft, cm, mm or in (default m)");
    command.add_option("--metres-per-level", settings.metresPerLevel, "Height of a storey, 2 to 6 m")
        ->capture_default_str()
        ->check(within(2.0, 6.0))
        ->type_name("M");
    command
        .add_option("--default-height", settings.defaultHeightM,
                    "Height of buildings without height data, 1 to 1000 m")
        ->capture_default_str()
        ->check(within(1.0, 1000.0))
        ->type_name("M");
}

void addTerrainOptions(CLI::App& command, ReadSettings& settings) {
    addChoice<TerrainFromBases>(
        command, "--terrain-from-bases", settings.terrainFromBases,
        {{"auto", TerrainFromBases::automatic},
         {"always", TerrainFromBases::always},
         {"never", TerrainFromBases::never}},
        "If there is no terrain, derive one from the ground elevations of the buildings; auto (default): "
        "only where neighbours stand at different heights")
        ->type_name("WHEN");
    addChoice<TerrainShows>(
        command, "--terrain-shows", settings.terrainShows,
        {{"auto", TerrainShows::automatic},
         {"ground", TerrainShows::ground},
         {"surface", TerrainShows::surface}},
        "What terrain rasters show: the bare ground, or a surface with the buildings on it; auto "
        "(default): a surface where they jump at the outlines of buildings")
        ->type_name("WHAT");
    command.add_flag("--heights-from-surface", settings.heightsFromSurface,
                     "Give buildings without a height that of the surface model above the ground");
}

void addMeshOptions(CLI::App& command, ReadSettings& settings) {
    addMeshAxesOptions(command, settings);
    command
        .add_option("--mesh-north", settings.meshNorthDeg,
                    "Meshes: azimuth of the mesh's north axis from true north, clockwise, degrees")
        ->capture_default_str()
        ->check(within(-360.0, 360.0))
        ->type_name("DEG");
    addLonLatOption(command, "--mesh-anchor", settings.meshAnchor,
                    "Meshes: position of the mesh's origin, degrees");
}

}  // namespace

void addMeshAxesOptions(CLI::App& command, ReadSettings& settings) {
    addChoice<UpAxis>(command, "--up", settings.upAxis,
                      {{"auto", UpAxis::automatic}, {"y", UpAxis::y}, {"z", UpAxis::z}},
                      "Meshes: the axis that points up, y or z; auto (default): as the format says or the "
                      "shape suggests")
        ->type_name("AXIS");
    addUnit(command, "--mesh-unit", settings.meshUnit,
            "Meshes: unit of the coordinates: m, ft, us-ft, cm, mm or in (default m)");
}

void addStandOption(CLI::App& command, ReadSettings& settings) {
    addChoice<Stand>(command, "--stand", settings.stand,
                     {{"auto", Stand::automatic}, {"terrain", Stand::terrain}, {"absolute", Stand::absolute}},
                     "Where buildings stand: each on the terrain, or at the elevations that the file states "
                     "(absolute); auto (default): as its bases lie against the terrain")
        ->type_name("HOW");
}

void addReadOptions(CLI::App& command, ReadOptions& options) {
    ReadSettings& settings = options.settings;
    command.add_option("files", options.files, options.filesHelp)->required()->type_name("FILE");
    addHeightOptions(command, settings);
    command.add_option("--layer", settings.layer, "Read this layer only")->type_name("NAME");
    command
        .add_option("--crs", settings.crs,
                    "Coordinate reference system of files that do not state it: EPSG:2263")
        ->type_name("CRS");
    command.add_option("--lod", settings.lod, "CityJSON: level of detail (default: the highest)")
        ->type_name("LOD");
    command
        .add_option("--far-away", settings.farAwayM,
                    "Leave out features farther than this from the middle of the data, m")
        ->capture_default_str()
        ->check(within(100, 200000))
        ->type_name("M");
    addTerrainOptions(command, settings);
    addStandOption(command, settings);
    addMeshOptions(command, settings);
}

}  // namespace noonmark::cli
