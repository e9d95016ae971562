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

/// The horizons of a square on level ground among prisms at all azimuths of a batch: walls are looked through
/// once for all of them. Keeps its memory; one for each thread.
class BatchHorizons {
public:
    /// From now on: these bins, of one batch (fansOf). `cellM`: metres a cell.
    void begin(std::span<const SweptBin> bins, double cellM);
    [[nodiscard]] const AzimuthBatch& batch() const { return lanes_->batch; }
    /// As BinWalls::find() wants it.
    [[nodiscard]] float lowestTan() const { return lanes_->lowestTan; }

    /// Raises the horizons of the block's cells in `masks`. `walls`: only prisms, found for this batch.
    void raise(const BinWalls& walls, const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks);

    /// What raise() made of a bin: codes of the block's cells in `masks`, 16 a line (row, or column where
    /// swapped), noHorizon for the others; null where all are noHorizon. Valid until the next call.
    const HorizonCode* codes(std::size_t bin);

private:
    /// Walls that a bin's horizons are still to be raised to.
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
    std::vector<HorizonCode> lowest_;           // of each bin's suns
    std::vector<BlockRows> lines_;              // of each bin
    alignas(64) float cots_[BatchLanes::most];  // of the lowest horizons that matter; one a bin
    std::array<Waiting, BatchLanes::most> waiting_;
    unsigned raised_ = 0;                       // bins, as bits
    BlockHorizons horizons_[BatchLanes::most];  // of raised bins
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

}  // namespace noonmark
