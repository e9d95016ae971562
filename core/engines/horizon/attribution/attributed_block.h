#pragma once

#include "core/engines/horizon/sweep/uneven_block.h"

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

}  // namespace noonmark
