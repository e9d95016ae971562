#pragma once

// The folder core/study/tiles computes regions of any size, tile after tile. runTiledStudy() (this file)
// divides the region (core/receivers/tile_plan.h). What a tile gives is a TileMeasure (tile_runner.h): the
// shadow of a city (shadow_measure.h), the timelines of places (timeline_measure.h), their sun
// (by_place_measure.h), or a measure of scenarios. TileRunner runs the missing tiles and stores each answer
// as a TileResult (tile_journal.h), from which a killed run can be resumed, and as a file: a raster with the
// bands of tile_maps.h, or lines of JSON. In the end MonthSums (this file) adds up the months of the tiles,
// and tile_maps.h joins the tiles into one GeoTIFF for each map.

#include <filesystem>
#include <map>
#include <span>
#include <stop_token>
#include <string>

#include "core/io/files/write_text.h"
#include "core/receivers/tile_plan.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/tiles/tile_journal.h"

namespace noonmark {

/// The shadow of the months of a study, added up over its tiles.
class MonthSums {
public:
    void add(const TileResult& tile) { add(tile, tile.monthMinutes); }
    /// The same with trees: TileResult::monthMinutesOf().
    void add(const TileResult& tile, const std::vector<double>& minutes);

    /// Nothing unless the settings ask for months. `sun`: of the study.
    [[nodiscard]] std::vector<MonthShadow> months(const StudySettings& settings, const SunSteps& sun,
                                                  double cellAreaM2) const;

private:
    std::vector<double> minutes_;
    std::size_t receivers_ = 0;
};

/// All tiles together with trees of one column.
struct ShadedTiles {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    ShadowStatistics statistics;
    std::vector<MonthShadow> months;  ///< if the settings ask for them
};
/// The columns that tiles have which trees reach; without, if none is reached.
TreeColumns findColumns(std::span<const TileResult* const> tiles);
/// These columns, evergreens first; tiles that no tree reaches count as they are.
std::vector<ShadedTiles> sumWithTrees(std::span<const TileResult* const> tiles, TreeColumns columns,
                                      const StudySettings& settings, const SunSteps& sun, double cellAreaM2);
/// Whether longest runs were counted in all columns.
bool haveRuns(std::span<const ShadedTiles> withTrees);
std::vector<MonthsWithTrees> listMonthsWithTrees(std::span<const ShadedTiles> withTrees);

struct TiledStudySettings {
    /// As many cells as the horizon sweep computes in one piece for a year, and whole blocks of the file.
    static constexpr int defaultTileCells = 768;
    static constexpr int minTileCells = 64;
    static constexpr int maxTileCells = 4096;

    StudySettings study;
    int tileCells = defaultTileCells;  ///< cells along a side
    FileTags tags = {};                ///< tags of the map: makeProvenanceTags()
};

/// A study whose cells were never in memory all at once.
struct TiledStudy {
    /// The study as by runStudy, but without cells: `receivers` and `field` hold the grid and no arrays, Cost
    /// the sums over the tiles.
    Study study;
    TilePlan plan;
    /// Number of tiles by the key of the engine that computed them
    std::map<std::string, std::size_t> tilesByEngine;
    std::vector<MonthShadow> months;                 ///< if the settings ask for them
    TreeColumns treeColumns = TreeColumns::without;  ///< that trees reach tiles in
    std::vector<ShadedTiles> withTrees{};            ///< these columns
    std::size_t treesUsed = 0;                       ///< trees whose shadow can reach the region
    std::string treesHow{};                          ///< how they were weighed, in words
    std::size_t emptyTiles = 0;                      ///< tiles without a receiver
    std::size_t resumedTiles = 0;                    ///< tiles that an earlier run had finished
};

/// Computes the shadow over a region of any size, tile after tile, into one GeoTIFF with overviews: gross
/// and, if every tile counted them, continuous minutes; NaN where there is no receiver. If the engine's cells
/// do not depend on their surroundings, cells and statistics equal those of runStudy over the whole region
/// (sums are added in another order: 1e-12).
///
/// If the settings ask for months, `by_month.tif` is written into the same folder; where trees reach a tile,
/// `shadow_evergreen.tif` and `shadow_seasonal.tif`, and their months.
///
/// Finished tiles are stored in the folder `file` + ".tiles" until all are done (TileJournal): running the
/// same study again after a kill resumes there. The engine `auto` may pick a different engine for each tile;
/// tilesByEngine says which. The error is measured on a sample in each tile and stated for the whole region.
///
/// Memory: the city, its ray scene if rays are traced, and one tile; not the region. Errors: as runStudy,
/// TileJournal and GeoTiffWriter. Reports progress with the remaining time; cancelled() within 0.2 s,
/// finished tiles remain.
Result<TiledStudy> runTiledStudy(const City& city, const TiledStudySettings& settings,
                                 const std::filesystem::path& file, Progress& progress, std::stop_token stop,
                                 const EngineList& engines = coreEngines());

/// studyJson with the months of the tiles, plus `tiles`: side_cells, count, empty, resumed, by_engine.
std::string tiledStudyJson(const TiledStudy& tiled);

}  // namespace noonmark
