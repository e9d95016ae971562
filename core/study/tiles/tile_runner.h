#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_journal.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

/// The answer for one tile.
struct TileAnswer {
    TileResult result;  ///< without its number and its time
    /// The values of the bands of all maps, each in grid order; none if the tile has no receiver, and none of
    /// the maps with trees if no tree reaches it
    std::vector<std::vector<float>> bands{};
    /// Lines of JSON instead, of a measure without maps: TileResult::lines of them
    std::string lines{};
};

/// What is measured in the tiles of a study.
class TileMeasure {
public:
    virtual ~TileMeasure() = default;

    /// The bands of a tile's file.
    [[nodiscard]] virtual std::vector<TileMap> maps() const = 0;

    /// Measures the cells of `tile`, a part of the study's grid. cancelled() when stopped.
    virtual Result<TileAnswer> measure(const Grid& tile, Progress& progress, const std::stop_token& stop) = 0;
};

/// What a measure works with. Holds references, which must outlive it.
struct TileQuestion {
    const StudySettings& settings;
    const SunSteps& sun;
    const Engine& engine;
    Grid whole;  ///< of which the tiles are parts
};

/// Measures the tiles of a study one by one and stores them in a journal. Holds references to its arguments,
/// which must outlive it.
class TileRunner {
public:
    TileRunner(TileMeasure& measure, const TilePlan& plan, const Frame& frame, TileJournal& journal);

    /// Writes the tile's cells, or its lines, to its file and its numbers to the journal. `contentHash`:
    /// stored with the tile, and if it is not empty, so are the size and the hash of its file.
    Result<void> run(std::size_t tile, Progress& progress, const std::stop_token& stop,
                     const std::string& contentHash = {});

private:
    [[nodiscard]] Result<void> write(const TileAnswer& answer) const;
    [[nodiscard]] Result<void> writeMaps(const std::filesystem::path& file, const TileAnswer& answer) const;

    TileMeasure& measure_;
    const TilePlan& plan_;
    const Frame& frame_;
    TileJournal& journal_;
    std::vector<RasterBand> bands_;  ///< of a tile's file
};

/// A tile to compute. `contentHash`: as TileRunner::run() takes it.
struct MissingTile {
    std::size_t number = 0;
    std::string contentHash{};
};

struct TileTotals {
    std::size_t tiles = 0;
    double cells = 0;

    void add(const Grid& tile) { add(TileTotals{1, double(tile.size())}); }
    void add(const TileTotals& other) {
        tiles += other.tiles;
        cells += other.cells;
    }
    void subtract(const TileTotals& other) {
        tiles -= other.tiles;
        cells -= other.cells;
    }
};

/// What is left of the tiles of a study, or of a task.
struct TilesLeft {
    std::vector<MissingTile> missing;
    TileTotals done;   ///< before
    TileTotals later;  ///< that another call computes: they count in the remaining time
};

/// Computes the missing tiles one after the other. Reports progress as "tile 12 of 96" with the remaining
/// time. cancelled() between tiles and within them; finished tiles remain.
Result<void> runTiles(TileRunner& runner, const TilePlan& plan, const TilesLeft& left, Progress& progress,
                      const std::stop_token& stop);

/// checkMemory() of one tile over this city: the size of the region does not matter.
Result<void> checkTileMemory(const City& city, const TilePlan& plan, StudySettings settings,
                             const EngineList& engines);

}  // namespace noonmark
