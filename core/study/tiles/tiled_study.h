#pragma once

#include <filesystem>
#include <map>
#include <stop_token>
#include <string>

#include "core/io/files/file_tags.h"
#include "core/receivers/tile_plan.h"
#include "core/study/study.h"

namespace noonmark {

struct TiledStudySettings {
    /// What the horizon sweep takes in one piece for a year, and whole blocks of the file.
    static constexpr int usualTileCells = 768;
    static constexpr int minTileCells = 64;
    static constexpr int maxTileCells = 4096;

    StudySettings study;
    int tileCells = usualTileCells;  ///< along a side
    FileTags tags = {};              ///< of the map: provenanceTags()
};

/// A study whose cells never were in memory at once.
struct TiledStudy {
    /// The study as runStudy would give it, but without cells: `receivers` and `field` hold the grid and no
    /// arrays, Cost the sums over the tiles.
    Study study;
    TilePlan plan;
    std::map<std::string, std::size_t> tilesByEngine;  ///< keys of the engines that did them
    std::size_t emptyTiles = 0;                        ///< without a receiver
    std::size_t resumedTiles = 0;                      ///< found finished by a run before this one
};

/// The shadow over a region of any size, tile after tile, into one GeoTIFF with overviews: gross and, where
/// every tile counted them, continuous minutes, NaN where there is no receiver. Cells and figures are those
/// of runStudy over the whole region, where the engine's cells do not depend on what is around them (sums in
/// another order: 1e-12).
///
/// What is finished lies in the folder `file` + ".tiles" until all is done (TileJournal): who runs the same
/// study again after a kill goes on there. Another engine may be picked for each tile by `auto`;
/// tilesByEngine says which. The error is measured on a sample in each tile and stated for all.
///
/// Memory: the city, its ray scene where rays are traced, and one tile; not the region. Errors: as runStudy,
/// and what TileJournal and GeoTiffWriter say. Reports progress with the time that is left; cancelled()
/// within 0.2 s, what is finished stays.
Result<TiledStudy> runTiledStudy(const City& city, const TiledStudySettings& settings,
                                 const std::filesystem::path& file, Progress& progress, std::stop_token stop,
                                 const EngineList& engines = coreEngines());

/// studyJson, and `tiles`: side_cells, count, empty, resumed, by_engine.
std::string tiledStudyJson(const TiledStudy& tiled);

}  // namespace noonmark
