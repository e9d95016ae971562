#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/geometry/azimuth_batch.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

/// A wall relative to a block's first cell.
struct WallAhead {
    glm::dvec2 low, high;  ///< across and along of the cell minus those of the wall's ends
    float topM;            ///< height
    float nearestAlong;    ///< `along` of the block's nearest cells minus that of the wall's farthest point
};

/// The same at each azimuth of a batch, with the meaning of WallOnBlock.
struct WallInBatch {
    alignas(64) float low[BatchLanes::maximum], high[BatchLanes::maximum];
    alignas(64) float slope[BatchLanes::maximum], perRise[BatchLanes::maximum];
};

/// Fills `in` and returns as bits the azimuths at which the wall faces away from the sun and may raise a
/// horizon with one of these cotangents; entries of other azimuths are unspecified. The margin exceeds
/// rounding, so azimuths that are left out change no bit. 5 ns.
unsigned findRaisingAzimuths(const BatchLanes& batch, const float* cots, const WallAhead& wall,
                             WallInBatch& in);

/// The horizons of a block on level ground, among prisms, at all azimuths of a batch; walls are searched once
/// for all of them. Reuses its memory; one per thread.
class BatchHorizons {
public:
    /// Selects the bins, which must form one batch (groupIntoBatches). `cellM`: metres per cell.
    void begin(std::span<const SweptBin> bins, double cellM);
    [[nodiscard]] const AzimuthBatch& batch() const { return lanes_->batch; }
    /// Parameter of BinWalls::find().
    [[nodiscard]] float lowestTan() const { return lanes_->lowestTan; }

    /// Raises the horizons of the block's cells in `masks`. `walls`: prisms only, found for this batch.
    void raise(const BinWalls& walls, const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks);

    /// The result of raise() for a bin: codes of the block's cells in `masks`, 16 per row (column if
    /// swapped), noHorizon for other cells; null if all are noHorizon. Valid until the next call.
    const HorizonCode* codes(std::size_t bin);

private:
    /// Walls found for a bin but not yet applied to its horizons.
    struct Waiting {
        static constexpr std::size_t maximum = 32;
        std::size_t count = 0;
        std::array<WallOnBlock, maximum> walls;
    };
    [[nodiscard]] float highestCot() const;
    void add(const WallPiece& piece, const BlockPlace& place, const ReceiverBlocks::Masks& masks);
    bool raiseWaiting(const ReceiverBlocks::Masks& masks);
    void raise(std::size_t bin, const ReceiverBlocks::Masks& masks);

    std::optional<BatchLanes> lanes_;
    std::vector<HorizonCode> lowest_;              // code of each bin's lowest sun
    std::vector<BlockRows> rows_;                  // one per bin
    alignas(64) float cots_[BatchLanes::maximum];  // of each bin's lowest relevant horizon
    std::array<Waiting, BatchLanes::maximum> waiting_;
    unsigned raised_ = 0;                          // bins with raised horizons, as bits
    BlockHorizons horizons_[BatchLanes::maximum];  // of raised bins
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

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
