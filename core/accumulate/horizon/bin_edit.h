#pragma once

#include <vector>

#include "core/accumulate/horizon/bin_sweep.h"
#include "core/accumulate/horizon/kept_walls.h"

namespace noonmark {

/// What changed in a tile, in the blocks' order.
struct TileEdit {
    const KeptWalls& walls;  ///< of the city as it is now
    const WallChange& change;
    const ReceiverBlocks& blocks;                            ///< as they are now, all cells numbered
    std::vector<ReceiverBlocks::Masks> newRows, newColumns;  ///< cells that have become receivers
    std::vector<std::size_t> newBlocks;                      ///< with such cells
    std::vector<std::uint32_t> newNumbers;                   ///< of such cells: their codes say nothing
    double cellM;
};

/// A horizon that is another now.
struct CodeChange {
    std::uint32_t number;
    HorizonCode before, after;
};

/// Brings the horizons of one azimuth up to date. Walls that are gone made a horizon just where they alone
/// give the same code; there, and where receivers are new, it is found again from all walls, unless a new
/// wall gives at least as much. New walls raise horizons. The codes are those of a sweep of the whole, bit
/// for bit. One for each thread.
class BinEdit {
public:
    /// Returns what changed; valid until the next call.
    std::span<const CodeChange> run(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest,
                                    std::span<HorizonCode> codes);

private:
    struct Lost {
        std::size_t block;
        ReceiverBlocks::Masks masks;
    };
    void findBlocks(const TileEdit& edit, const ShadowAxes& axes, HorizonCode lowest);
    void look(const TileEdit& edit, const ShadowAxes& axes, std::size_t block, std::span<HorizonCode> codes);
    void findAgain(const TileEdit& edit, const ShadowAxes& axes, HorizonCode lowest,
                   std::span<HorizonCode> codes);
    void put(std::span<HorizonCode> codes, std::uint32_t number, HorizonCode code);

    SquareSweep removed_, added_, all_;
    std::vector<std::size_t> blocks_;  // that may lie in the shadow of what went or came
    std::vector<Lost> lost_;
    std::vector<StandingPrism> prisms_;
    std::vector<CodeChange> changes_;
};

}  // namespace noonmark
