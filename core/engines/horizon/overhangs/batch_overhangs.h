#pragma once

#include <array>
#include <span>
#include <stop_token>

#include "core/engines/horizon/geometry/azimuth_batch.h"
#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

/// The horizons of one block as a sweep gives them.
struct SweptBlock {
    std::size_t block;         ///< index
    const HorizonCode* codes;  ///< 16 a line; null: all are noHorizon
    bool swapped;              ///< lines are columns
};

/// What hangs, at the azimuths of a batch, looked at from blocks whose horizons have just been found. Keeps
/// its memory; one for each thread.
class BatchOverhangs {
public:
    /// From now on: these bins, of one batch, and this tile. All that is named must outlive what follows.
    void begin(std::span<const OverhangShapes* const> shapes, const OverhangTile& tile,
               std::span<const SweptBin> bins, double cellM, const std::stop_token& stop);

    /// Returns a block's codes raised where what hangs hides all suns above the horizon up to there, valid
    /// until the next call, and calls visit(cell, low, high) for what it hides apart from it: of cell 16 x
    /// row + column, of one cell from below, disjoint.
    template <class Visit>
    const HorizonCode* raise(std::size_t bin, const SweptBlock& swept, const ReceiverBlocks& blocks,
                             const BlockGrounds& grounds, const Visit& visit);

private:
    [[nodiscard]] static std::size_t placeOf(const ReceiverBlocks& blocks, std::size_t block);
    void setBlock(const SweptBlock& swept, const ReceiverBlocks& blocks, const BlockGrounds& grounds);

    std::array<OverhangSweep, BatchLanes::most> sweeps_;  // one a bin
    std::array<HorizonCode, BatchLanes::most> lowest_{};
    ViewingBlock from_;
    BlockCodes codes_;
};

template <class Visit>
const HorizonCode* BatchOverhangs::raise(std::size_t bin, const SweptBlock& swept,
                                         const ReceiverBlocks& blocks, const BlockGrounds& grounds,
                                         const Visit& visit) {
    const std::size_t place = placeOf(blocks, swept.block);
    const HorizonCode lowest = swept.codes == nullptr
                                   ? noHorizon
                                   : findLowest(swept.codes, blocks.masks(swept.block, swept.swapped));
    if (!sweeps_[bin].maySee(place, lowest)) return swept.codes;
    setBlock(swept, blocks, grounds);
    bool raised = false;
    sweeps_[bin].look(place, from_, lowest, [&](int cell, HorizonCode low, HorizonCode high) {
        constexpr int side = ReceiverBlocks::side;
        HorizonCode& horizon = codes_.values[cell];
        // Below the lowest sun there is nothing to see.
        if (int(low) > std::max(int(horizon) + 1, int(lowest_[bin])))
            return visit(swept.swapped ? cell % side * side + cell / side : cell, low, high);
        horizon = std::max(horizon, high);
        raised = true;
    });
    return raised ? codes_.values : swept.codes;
}

}  // namespace noonmark
