#pragma once

#include <cstdint>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// One code a cell of a block, line by line.
struct alignas(64) BlockCodes {
    HorizonCode values[ReceiverBlocks::cells];
};

/// Of the cells in `masks`; the highest code where there is none.
HorizonCode findLowest(const HorizonCode* codes, const ReceiverBlocks::Masks& masks);

/// Sets the codes of cells that are not in `masks`.
void setOthers(const ReceiverBlocks::Masks& masks, HorizonCode code, BlockCodes& codes);

/// Rows as columns.
void transpose(const HorizonCode* from, BlockCodes& to);

/// Raises codes to others.
void raise(const HorizonCode* others, BlockCodes& codes);

/// For each line the cells in `masks` where two blocks differ, as bits.
void findDifferences(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
                     ReceiverBlocks::Masks& differ);

/// For each line the cells in `masks` where the codes are the same and not noHorizon.
void findEqual(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
               ReceiverBlocks::Masks& equal);

}  // namespace noonmark
