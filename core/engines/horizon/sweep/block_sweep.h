#pragma once

#include <cstdint>
#include <stop_token>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/sweep/batch_horizons.h"

namespace noonmark {

/// Computes the horizons of a tile's blocks at one azimuth. Reuses its memory; one per thread.
class BlockSweep {
public:
    /// Selects the obstacles and the extent of the cells. Horizons that hide no sun of code `lowest` become
    /// noHorizon. `cellM`: metres per cell. Incomplete if stopped.
    void begin(const WallList& walls, const Obstacles& obstacles, glm::dvec2 away, const ShadowExtent& extent,
               HorizonCode lowest, double cellM, const std::stop_token& stop);

    /// Codes of the block's cells in `masks`, 16 per row (column if swapped), noHorizon for other cells; null
    /// if all are noHorizon. Valid until the next call.
    const HorizonCode* codes(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                             const BlockGround& ground = {});

    /// The same with the building that makes each horizon and the horizon without that building; null if all
    /// are level.
    const AttributedCodes* attributedCodes(const ReceiverBlocks::Block& block,
                                           const ReceiverBlocks::Masks& masks,
                                           const BlockGround& ground = {});

    /// Number of prisms and solids out of reach.
    [[nodiscard]] std::uint64_t outOfReach() const { return walls_.outOfReach(); }

private:
    template <class Horizons>
    bool raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
               const BlockGround& ground, Horizons& horizons);

    BinWalls walls_;
    ShadowAxes axes_{{0, 1}};
    BlockRows rows_{0, 1};
    HorizonCode lowest_ = 0;
    bool even_ = true;  // only prisms on level ground: the fast path
    float risePerMetre_ = 0;
    BatchHorizons batch_;
    UnevenHorizons uneven_;
    BlockNeed need_;
    AttributedHorizons ranked_;
    AttributedCodes rankedCodes_;
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

}  // namespace noonmark
