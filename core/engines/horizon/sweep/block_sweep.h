#pragma once

#include <cstdint>
#include <stop_token>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/sweep/batch_horizons.h"

namespace noonmark {

/// Squares of a tile at one azimuth. Keeps its memory from one to the next; one for each thread.
class BlockSweep {
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
    const AttributedCodes* attributedCodes(const ReceiverBlocks::Block& block,
                                           const ReceiverBlocks::Masks& masks,
                                           const BlockGround& ground = {});

    /// Prisms and solids.
    [[nodiscard]] std::uint64_t outOfReach() const { return walls_.outOfReach(); }

private:
    template <class Horizons>
    bool raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
               const BlockGround& ground, Horizons& horizons);

    BinWalls walls_;
    ShadowAxes axes_{{0, 1}};
    BlockRows lines_{0, 1};
    HorizonCode lowest_ = 0;
    bool even_ = true;  // prisms only: the fast way, on level ground
    float risePerMetre_ = 0;
    BatchHorizons batch_;
    UnevenHorizons uneven_;
    BlockNeed need_;
    AttributedHorizons ranked_;
    AttributedCodes rankedCodes_;
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

}  // namespace noonmark
