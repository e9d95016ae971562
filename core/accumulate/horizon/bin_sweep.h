#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/bin_walls.h"
#include "core/accumulate/horizon/raise_block.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// The horizons of a tile at one azimuth. Keeps its memory from one to the next; one for each thread.
class BinSweep {
public:
    /// Writes the code of each number of `blocks` (padding: noHorizon), unless stopped; horizons that hide no
    /// sun of code `lowest` are noHorizon. Returns the number of prisms out of reach. `cellM`: metres a cell.
    std::uint64_t sweep(const WallList& walls, const ReceiverBlocks& blocks, glm::dvec2 away,
                        HorizonCode lowest, double cellM, HorizonCode* codes, const std::stop_token& stop);

private:
    void raise(const ReceiverBlocks::Block& block, const ShadowAxes& axes, const BlockLines& lines,
               float lowest);

    BinWalls walls_;
    BlockHorizons horizons_;
};

}  // namespace noonmark
