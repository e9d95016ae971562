#pragma once

#include <cstdint>
#include <vector>

#include "core/accumulate/horizon/ranked_block.h"
#include "core/accumulate/horizon/receiver_blocks.h"

namespace noonmark {

/// The horizons of a tile at one azimuth with who makes them, one a number.
struct TileRanks {
    std::vector<HorizonCode> codes, others;  ///< as in RankedCodes
    std::vector<std::uint32_t> buildings;    ///< of codes that are not noHorizon

    /// No horizon anywhere.
    void clear(std::size_t numbers) {
        codes.assign(numbers, noHorizon);
        others.assign(numbers, noHorizon);
        buildings.resize(numbers);
    }

    /// Those of a block, as SquareSweep gives them.
    void write(const RankedCodes& square, const ReceiverBlocks& blocks, const ReceiverBlocks::Block& block,
               bool swapped) {
        const std::uint8_t* places = blocks.places(block, swapped);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            codes[block.first + n] = square.codes[places[n]];
            others[block.first + n] = square.others[places[n]];
            buildings[block.first + n] = std::uint32_t(square.buildings[places[n]]);
        }
    }
};

}  // namespace noonmark
