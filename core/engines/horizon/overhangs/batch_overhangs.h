#pragma once

#include <array>
#include <span>
#include <stop_token>

#include "core/engines/horizon/geometry/azimuth_batch.h"
#include "core/engines/horizon/geometry/block_grounds.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_sweep.h"

namespace noonmark {

/// The horizons of one block as computed by a sweep.
struct SweptBlock {
    std::size_t block;         ///< index
    const HorizonCode* codes;  ///< 16 per row; null: all are noHorizon
    bool swapped;              ///< rows are columns
};

/// Adds overhangs, at the azimuths of a batch, to blocks whose horizons have just been computed. Reuses its
/// memory; one per thread.
class BatchOverhangs {
public:
    /// Selects the bins, which must form one batch, and the tile. All arguments must outlive the calls that
    /// follow.
    void begin(std::span<const OverhangShapes* const> shapes, const OverhangTile& tile,
               std::span<const SweptBin> bins, double cellM, const std::stop_token& stop);

    /// Returns a block's codes, raised where an overhang hides all suns from the horizon up to its top; valid
    /// until the next call. Calls visit(cell, low, high) for the intervals that overhangs hide separately
    /// from the horizon: of cell 16 x row + column; the intervals of a cell ascend and are disjoint.
    template <class Visit>
    const HorizonCode* raise(std::size_t bin, const SweptBlock& swept, const ReceiverBlocks& blocks,
                             const BlockGrounds& grounds, const Visit& visit);

private:
    [[nodiscard]] static std::size_t placeOf(const ReceiverBlocks& blocks, std::size_t block);
    void setBlock(const SweptBlock& swept, const ReceiverBlocks& blocks, const BlockGrounds& grounds);

    std::array<OverhangSweep, BatchLanes::most> sweeps_;  // one per bin
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
        // No suns are lower than the lowest sun, so the space below it does not separate an interval from the
        // horizon.
        if (int(low) > std::max(int(horizon) + 1, int(lowest_[bin])))
            return visit(swept.swapped ? cell % side * side + cell / side : cell, low, high);
        horizon = std::max(horizon, high);
        raised = true;
    });
    return raised ? codes_.values : swept.codes;
}

}  // namespace noonmark
