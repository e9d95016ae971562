#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The horizons of a tile at one azimuth with who makes them, one a number.
struct AttributedTile {
    std::vector<HorizonCode> codes, others;  ///< as in AttributedCodes
    std::vector<std::uint32_t> buildings;    ///< of codes that are not noHorizon

    /// No horizon anywhere.
    void clear(std::size_t numbers) {
        codes.assign(numbers, noHorizon);
        others.assign(numbers, noHorizon);
        buildings.resize(numbers);
    }

    /// Those of a block, as BlockSweep gives them.
    void write(const AttributedCodes& swept, const ReceiverBlocks& blocks, const ReceiverBlocks::Block& block,
               bool swapped) {
        const std::uint8_t* places = blocks.places(block, swapped);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            codes[block.first + n] = swept.codes[places[n]];
            others[block.first + n] = swept.others[places[n]];
            buildings[block.first + n] = std::uint32_t(swept.buildings[places[n]]);
        }
    }
};

}  // namespace noonmark
