#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_batch.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/block_place.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

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
        static constexpr std::size_t most = 32;
        std::size_t count = 0;
        std::array<WallOnBlock, most> walls;
    };
    [[nodiscard]] float highestCot() const;
    void add(const WallPiece& piece, const BlockPlace& place, const ReceiverBlocks::Masks& masks);
    bool raiseWaiting(const ReceiverBlocks::Masks& masks);
    void raise(std::size_t bin, const ReceiverBlocks::Masks& masks);

    std::optional<BatchLanes> lanes_;
    std::vector<HorizonCode> lowest_;           // code of each bin's lowest sun
    std::vector<BlockRows> rows_;               // one per bin
    alignas(64) float cots_[BatchLanes::most];  // of each bin's lowest relevant horizon
    std::array<Waiting, BatchLanes::most> waiting_;
    unsigned raised_ = 0;                       // bins with raised horizons, as bits
    BlockHorizons horizons_[BatchLanes::most];  // of raised bins
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

}  // namespace noonmark
