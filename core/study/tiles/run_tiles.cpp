#include "core/study/tiles/run_tiles.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/study/memory_need.h"
#include "core/study/remaining_time.h"

namespace noonmark {

Result<void> runTiles(TileRunner& runner, const TilePlan& plan, const TilesLeft& left, Progress& progress,
                      const std::stop_token& stop) {
    const auto cellsOf = [&](const MissingTile& tile) { return double(plan.tile(tile.number).size()); };
    double cells = left.done.cells + left.later.cells;
    for (const MissingTile& tile : left.missing) cells += cellsOf(tile);
    PiecewiseProgress pieces(progress, cells, left.done.cells);
    const std::size_t count = left.done.tiles + left.missing.size() + left.later.tiles;
    std::size_t number = left.done.tiles;
    for (const MissingTile& tile : left.missing) {
        if (stop.stop_requested()) return cancelled();
        pieces.begin(fmt::format("tile {} of {}", ++number, count), cellsOf(tile));
        if (auto done = runner.run(tile.number, pieces, stop, tile.contentHash); !done) return done;
        pieces.end();
    }
    return {};
}

Result<void> checkTileMemory(const City& city, const TilePlan& plan, StudySettings settings,
                             const EngineList& engines) {
    const auto cellM = float(plan.whole.cellM);
    const float widthM = cellM * float(std::min(plan.side, plan.whole.columns));
    const float heightM = cellM * float(std::min(plan.side, plan.whole.rows));
    settings.region = makeRegionFromLocalBox({{0, 0}, {widthM, heightM}});
    return checkMemory(city, settings, engines);
}

}  // namespace noonmark
