#pragma once

#include <functional>
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
    double cellM;
};

/// Brings the horizons of one azimuth up to date. Walls that are gone made a horizon just where they alone
/// give the same code; there, and where receivers are new, it is found again from all walls. New walls raise
/// horizons. The codes are those of a sweep of the whole, bit for bit. One for each thread.
class BinEdit {
public:
    using OnChange = std::function<void(std::uint32_t number, HorizonCode before, HorizonCode after)>;

    void run(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest, std::span<HorizonCode> codes,
             const OnChange& changed);

private:
    struct Lost {
        std::size_t block;
        ReceiverBlocks::Masks masks;
    };
    void findBlocks(const TileEdit& edit, const ShadowAxes& axes);
    void findLost(const TileEdit& edit, const ShadowAxes& axes, std::span<const HorizonCode> codes);
    void findAgain(const TileEdit& edit, const ShadowAxes& axes, HorizonCode lowest,
                   std::span<HorizonCode> codes, const OnChange& changed);
    void raise(const TileEdit& edit, const ShadowAxes& axes, std::span<HorizonCode> codes,
               const OnChange& changed);

    SquareSweep removed_, added_, all_;
    std::vector<std::size_t> blocks_;  // that may lie in the shadow of what went or came
    std::vector<Lost> lost_;
    std::vector<StandingPrism> prisms_;
};

}  // namespace noonmark
