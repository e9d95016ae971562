#pragma once

#include <vector>

#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/changed_cells.h"
#include "core/accumulate/horizon/kept_walls.h"
#include "core/accumulate/horizon/open_parts.h"

namespace noonmark {

/// What changed in a tile, in the blocks' order.
struct TileEdit {
    const KeptWalls& walls;  ///< of the city as it is now
    const WallChange& change;
    const ReceiverBlocks& blocks;  ///< as they are now, all cells numbered
    const BlockGrounds& grounds;
    const OpenTile& open;       ///< nothing where nothing hangs nor hung
    const ChangedCells& cells;  ///< codes of new ones say nothing
    int columns;                ///< of the grid
    double cellM;
    const std::stop_token& stop;
};

/// A horizon that is another now.
struct CodeChange {
    std::uint32_t number;
    HorizonCode before, after;
};

/// Brings the horizons of one azimuth up to date. What is gone made a horizon just where it alone
/// gives the same code; there, and where receivers are new, it is found again from all that stands, unless
/// something new gives at least as much. What is new raises horizons. The codes are those of a sweep of the
/// whole, bit for bit. One for each thread.
class BinEdit {
public:
    /// Returns what changed, of each number once; valid until the next call. Less once stopped.
    std::span<const CodeChange> run(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest,
                                    std::span<HorizonCode> codes);

private:
    struct Lost {
        std::size_t block;
        ReceiverBlocks::Masks masks;
    };
    void findBlocks(const TileEdit& edit, const ShadowAxes& axes, HorizonCode lowest);
    void addSquares(const TileEdit& edit, const ShadowAxes& axes, const ShadowExtent& extent);
    void look(const TileEdit& edit, const ShadowAxes& axes, std::size_t block, std::span<HorizonCode> codes);
    void findAgain(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest, std::span<HorizonCode> codes);
    void put(std::span<HorizonCode> codes, std::uint32_t number, HorizonCode code);

    SquareSweep removed_, added_, all_;
    std::vector<std::size_t> blocks_;  // that may lie in the shadow of what went or came
    std::vector<Lost> lost_;
    std::vector<StandingPrism> prisms_;
    std::vector<CodeChange> changes_;
};

}  // namespace noonmark
