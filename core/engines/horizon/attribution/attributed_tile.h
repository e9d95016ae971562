#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The horizons of a tile at one azimuth with the buildings that make them, one per number.
struct AttributedTile {
    std::vector<HorizonCode> codes, others;  ///< as in AttributedCodes
    std::vector<std::uint32_t> buildings;    ///< valid where the code is not noHorizon

    /// Resets all horizons to noHorizon.
    void clear(std::size_t numbers) {
        codes.assign(numbers, noHorizon);
        others.assign(numbers, noHorizon);
        buildings.resize(numbers);
    }

    /// Writes the horizons of a block, as computed by BlockSweep.
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
