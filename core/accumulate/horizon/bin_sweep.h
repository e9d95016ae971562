#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/bin_walls.h"
#include "core/accumulate/horizon/raise_block.h"
#include "core/accumulate/horizon/ranked_block.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// Squares of a tile at one azimuth. Keeps its memory from one to the next; one for each thread.
class SquareSweep {
public:
    /// From now on: these obstacles, for cells in `extent`; horizons that hide no sun of code `lowest` are
    /// noHorizon. `cellM`: metres a cell. Less once stopped.
    void begin(const WallList& walls, const Obstacles& obstacles, glm::dvec2 away, const ShadowExtent& extent,
               HorizonCode lowest, double cellM, const std::stop_token& stop);

    /// Codes of the block's cells in `masks`, 16 a line (row, or column where swapped), noHorizon for the
    /// others; null where all are noHorizon. Valid until the next call.
    const HorizonCode* codes(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                             const BlockGround& ground = {});

    /// The same, with who makes the horizon and what it would be without them; null where all are level.
    const RankedCodes* rankedCodes(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                                   const BlockGround& ground = {});

    /// Prisms and solids.
    [[nodiscard]] std::uint64_t outOfReach() const { return walls_.outOfReach(); }

private:
    bool raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
               BlockHorizons& horizons);
    template <class Horizons>
    bool raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
               const BlockGround& ground, Horizons& horizons);

    BinWalls walls_;
    ShadowAxes axes_{{0, 1}};
    BlockLines lines_{0, 1};
    HorizonCode lowest_ = 0;
    bool even_ = true;  // prisms on level ground only: the fast way
    float risePerMetre_ = 0;
    BlockHorizons horizons_;
    UnevenHorizons uneven_;
    BlockNeed need_;
    RankedHorizons ranked_;
    RankedCodes rankedCodes_;
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

ShadowExtent extentOf(const TileBox& box, const ShadowAxes& axes);

/// Writes the code of each number of `blocks` (nobody's: noHorizon), unless stopped. Returns the number of
/// prisms and solids out of reach.
std::uint64_t sweepBin(SquareSweep& sweep, const WallList& walls, const ReceiverBlocks& blocks,
                       const BlockGrounds& grounds, glm::dvec2 away, HorizonCode lowest, double cellM,
                       std::span<HorizonCode> codes, const std::stop_token& stop);

/// The horizons of a tile with who makes them, one a number.
struct TileRanks {
    std::vector<HorizonCode> codes, others;  ///< as in RankedCodes
    std::vector<std::uint32_t> buildings;    ///< of codes that are not noHorizon
};

/// The same with who makes them: sizes and fills `ranks`.
void rankBin(SquareSweep& sweep, const WallList& walls, const ReceiverBlocks& blocks,
             const BlockGrounds& grounds, glm::dvec2 away, HorizonCode lowest, double cellM, TileRanks& ranks,
             const std::stop_token& stop);

}  // namespace noonmark
