#pragma once

#include "core/study/tiles/tile_runner.h"

namespace noonmark {

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
