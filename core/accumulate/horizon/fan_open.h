#pragma once

#include <array>
#include <span>
#include <stop_token>

#include "core/accumulate/horizon/azimuth_fan.h"
#include "core/accumulate/horizon/block_grounds.h"
#include "core/accumulate/horizon/open_sweep.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// The horizons of one square as a sweep gives them.
struct SweptSquare {
    std::size_t block;         ///< index
    const HorizonCode* codes;  ///< 16 a line; null: all are noHorizon
    bool swapped;              ///< lines are columns
};

/// What hangs, at the azimuths of a fan, looked at from squares whose horizons have just been found. Keeps
/// its memory; one for each thread.
class FanOpen {
public:
    /// From now on: these bins, of one fan, and this tile. All that is named must outlive what follows.
    void begin(std::span<const OpenShapes* const> shapes, const OpenTile& tile,
               std::span<const SweptBin> bins, double cellM, const std::stop_token& stop);

    /// Returns a square's codes raised where what hangs hides all suns above the horizon up to there, valid
    /// until the next call, and calls visit(cell, low, high) for what it hides apart from it: of cell 16 x
    /// row + column, of one cell from below, disjoint.
    template <class Visit>
    const HorizonCode* raise(std::size_t bin, const SweptSquare& square, const ReceiverBlocks& blocks,
                             const BlockGrounds& grounds, const Visit& visit);

private:
    [[nodiscard]] static std::size_t placeOf(const ReceiverBlocks& blocks, std::size_t block);
    void setSquare(const SweptSquare& square, const ReceiverBlocks& blocks, const BlockGrounds& grounds);

    std::array<OpenSweep, FanLanes::most> sweeps_;  // one a bin
    std::array<HorizonCode, FanLanes::most> lowest_{};
    OpenSquare from_;
    BlockCodes codes_;
};

template <class Visit>
const HorizonCode* FanOpen::raise(std::size_t bin, const SweptSquare& square, const ReceiverBlocks& blocks,
                                  const BlockGrounds& grounds, const Visit& visit) {
    const std::size_t place = placeOf(blocks, square.block);
    const HorizonCode lowest = square.codes == nullptr
                                   ? noHorizon
                                   : lowestOf(square.codes, blocks.masks(square.block, square.swapped));
    if (!sweeps_[bin].maySee(place, lowest)) return square.codes;
    setSquare(square, blocks, grounds);
    bool raised = false;
    sweeps_[bin].look(place, from_, lowest, [&](int cell, HorizonCode low, HorizonCode high) {
        constexpr int side = ReceiverBlocks::side;
        HorizonCode& horizon = codes_.values[cell];
        // Below the lowest sun there is nothing to see.
        if (int(low) > std::max(int(horizon) + 1, int(lowest_[bin])))
            return visit(square.swapped ? cell % side * side + cell / side : cell, low, high);
        horizon = std::max(horizon, high);
        raised = true;
    });
    return raised ? codes_.values : square.codes;
}

}  // namespace noonmark
