#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/api/tree_shade.h"
#include "core/geo/frame.h"
#include "core/io/files/write_text.h"
#include "core/io/write_raster.h"
#include "core/measures/colour_scale.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/tile_plan.h"
#include "core/study/study.h"
#include "core/study/tiles/tile_journal.h"

namespace noonmark {

/// The bands of a study's map: gross and, if `runs`, continuous shadow; then the same with trees. They hold
/// pointers to the field's arrays, which must outlive them.
inline std::vector<RasterBand> makeMapBands(const ShadowField& field, bool runs) {
    std::vector<RasterBand> bands{{"gross shadow", "min/day", &field.grossMin}};
    if (runs) bands.push_back({"continuous shadow", "min", &field.continuousMin});
    for (const ShadeColumn& column : listShadeColumns(field)) {
        const std::string with =
            column.column == TreeColumns::evergreen ? "trees as evergreens" : "trees with seasons";
        bands.push_back({"gross shadow, " + with, "min/day", &column.field->grossMin});
        if (runs && hasRuns(*column.field))
            bands.push_back({"continuous shadow, " + with, "min", &column.field->continuousMin});
    }
    return bands;
}

/// A raster that a study in tiles gives. The file of each tile holds the bands of all maps, one after the
/// other.
struct TileMap {
    std::string name;               ///< of its file, without ending: "shadow", "by_month"
    std::string title;              ///< for people
    std::vector<RasterBand> bands;  ///< names and units; no values
    std::size_t firstBand = 0;      ///< place of its first band in the files of tiles
    std::size_t runBands = 0;       ///< how many of its last bands hold continuous shadow, or its change
    std::optional<ColourScale> colours{};  ///< none: those of shadow, see makeShadowScale()
    /// Of a map with trees: its first band in the files of tiles that no tree reaches, those without trees.
    std::optional<std::size_t> withoutTrees{};
};

/// The colours of maps of shadow whose cells are never together in memory. Quantiles, which need them, become
/// as many equal classes.
ColourScale makeShadowScale(const ShadowStatistics& figures, double sunlitMinutesPerDay,
                            const LegendChoice& legend = {});
/// The colours of maps of months, which hold the minutes of shadow of the whole month: up to those with the
/// sun up in the month that has most of them. Range and typed classes of the legend, which are of a day, do
/// not count; quantiles as above.
ColourScale makeMonthScale(const SunSteps& sun, const LegendChoice& legend = {});
/// The choice for maps around zero whose cells are never held together.
LegendChoice withoutQuantiles(LegendChoice legend);

inline constexpr std::string_view monthMap = "by_month";  ///< the name of that of months

/// The maps that the settings of a study ask for: `shadow` (gross and continuous), and `by_month`, with a
/// band for each month of the sun; then each of them with trees of these columns, `shadow_evergreen`.
std::vector<TileMap> listTileMaps(const StudySettings& settings, const SunSteps& sun, TreeColumns columns);

/// The maps, and each of them with trees of these columns, whose bands follow in the files of tiles.
std::vector<TileMap> addMapsWithTrees(std::vector<TileMap> maps, TreeColumns columns);

/// The maps to be written: without the bands of continuous shadow unless `runs`, and `runsWithTrees` of maps
/// with trees. Tiles always have them, since whether runs were counted is decided for all tiles together.
std::vector<TileMap> listWrittenMaps(std::vector<TileMap> maps, bool runs, bool runsWithTrees);

/// The map of a tiled study.
struct MapFile {
    std::filesystem::path path;
    FileTags tags;
    bool overviews = true;
};

/// The raster file of a finished tile.
struct TileFile {
    std::filesystem::path path;
    bool hasTrees = false;  ///< it has the bands of the maps with trees
    /// The place of a map's first band in it.
    [[nodiscard]] std::size_t firstBandOf(const TileMap& map) const {
        return hasTrees ? map.firstBand : map.withoutTrees.value_or(map.firstBand);
    }
};
/// By tile number; no file for a tile without a receiver.
using TileFiles = std::map<std::size_t, std::optional<TileFile>>;
TileFiles listFiles(const TileJournal& journal);

/// Writes the bands of one map into a GeoTIFF, from the files of finished tiles, NaN in empty and missing
/// ones, with overviews if the file asks for them. Holds one tile in memory. Error: a tile that
/// cannot be read, a map that cannot be written; cancelled().
Result<void> assembleMap(const TilePlan& plan, const TileFiles& tiles, const Frame& frame,
                         const MapFile& file, const TileMap& map, Progress& progress,
                         const std::stop_token& stop);

}  // namespace noonmark
