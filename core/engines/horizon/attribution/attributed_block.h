#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/sweep/raise_block.h"

namespace noonmark {

/// The horizons of a block's cells together with the buildings that make them.
struct AttributedHorizons {
    BlockHorizons highest;
    CacheLine<std::int32_t> buildings[ReceiverBlocks::side];  ///< building that makes the horizon; -1: none
    BlockHorizons others;                                     ///< horizons without that building
    CacheLine<float> grounds[ReceiverBlocks::side];           ///< as in UnevenHorizons
};

/// The codes of these horizons, 16 per row.
struct AttributedCodes {
    alignas(64) HorizonCode codes[ReceiverBlocks::cells];
    alignas(64) HorizonCode others[ReceiverBlocks::cells];
    std::int32_t buildings[ReceiverBlocks::cells];
};

/// As for BlockHorizons. If two buildings give equally steep horizons, the cell is attributed to the first
/// one processed.
void clearBlock(const ReceiverBlocks::Masks& masks, AttributedHorizons& horizons);
void raiseBlock(const WallOnBlock& wall, const BlockRows& rows, AttributedHorizons& horizons);
void toCodes(const AttributedHorizons& horizons, HorizonCode lowest, AttributedCodes& codes);

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
