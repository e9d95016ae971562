#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/accumulate/horizon/azimuth_fan.h"
#include "core/accumulate/horizon/bin_walls.h"
#include "core/accumulate/horizon/block_place.h"
#include "core/accumulate/horizon/raise_block.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// The horizons of a square on level ground among prisms at all azimuths of a fan: walls are looked through
/// once for all of them. Keeps its memory; one for each thread.
class FanHorizons {
public:
    /// From now on: these bins, of one fan (fansOf). `cellM`: metres a cell.
    void begin(std::span<const SweptBin> bins, double cellM);
    [[nodiscard]] const AzimuthFan& fan() const { return lanes_->fan; }
    /// As BinWalls::find() wants it.
    [[nodiscard]] float lowestTan() const { return lanes_->lowestTan; }

    /// Raises the horizons of the block's cells in `masks`. `walls`: only prisms, found for this fan.
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

    std::optional<FanLanes> lanes_;
    std::vector<HorizonCode> lowest_;         // of each bin's suns
    std::vector<BlockLines> lines_;           // of each bin
    alignas(64) float cots_[FanLanes::most];  // of the lowest horizons that matter; one a bin
    std::array<Waiting, FanLanes::most> waiting_;
    unsigned raised_ = 0;                     // bins, as bits
    BlockHorizons horizons_[FanLanes::most];  // of raised bins
    alignas(64) HorizonCode codes_[ReceiverBlocks::cells];
};

}  // namespace noonmark
