#pragma once

#include "core/engines/horizon/sweep/uneven_block.h"

namespace noonmark {

/// The horizons of a block's cells with who makes them.
struct AttributedHorizons {
    Floats16 lines[ReceiverBlocks::side];    ///< as in BlockHorizons
    Ints16 buildings[ReceiverBlocks::side];  ///< whose it is; -1: nobody's
    Floats16 others[ReceiverBlocks::side];   ///< of the highest wall of any other building
    Floats16 grounds[ReceiverBlocks::side];  ///< as in UnevenHorizons
};

/// Their codes, 16 a line.
struct AttributedCodes {
    alignas(64) HorizonCode codes[ReceiverBlocks::cells];
    alignas(64) HorizonCode others[ReceiverBlocks::cells];
    std::int32_t buildings[ReceiverBlocks::cells];
};

/// As for BlockHorizons. Where two buildings are equally steep the one that came first has the cell.
void clearBlock(const ReceiverBlocks::Masks& masks, AttributedHorizons& horizons);
void raiseBlock(const WallOnBlock& wall, const BlockRows& lines, AttributedHorizons& horizons);
void toCodes(const AttributedHorizons& horizons, HorizonCode lowest, AttributedCodes& codes);

}  // namespace noonmark
