#pragma once

#include <stop_token>

#include "core/receivers/tile_plan.h"
#include "core/study/tiles/tile_journal.h"
#include "core/study/tiles/tile_measure.h"

namespace noonmark {

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

}  // namespace noonmark
