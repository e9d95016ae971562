#pragma once

#include <cstdint>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// One code per cell of a block, row by row.
struct alignas(64) BlockCodes {
    HorizonCode values[ReceiverBlocks::cells];
};

/// Lowest code of the cells in `masks`; the highest possible code if there are none.
HorizonCode findLowest(const HorizonCode* codes, const ReceiverBlocks::Masks& masks);

/// Sets the codes of cells that are not in `masks`.
void setOthers(const ReceiverBlocks::Masks& masks, HorizonCode code, BlockCodes& codes);

/// Swaps rows and columns.
void transpose(const HorizonCode* from, BlockCodes& to);

/// Raises each code to the other one if that is higher.
void raise(const HorizonCode* others, BlockCodes& codes);

/// For each row the cells in `masks` where two blocks differ, as bits.
void findDifferences(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
                     ReceiverBlocks::Masks& differ);

/// For each row the cells in `masks` where the codes are equal and not noHorizon.
void findEqual(const HorizonCode* a, const HorizonCode* b, const ReceiverBlocks::Masks& masks,
               ReceiverBlocks::Masks& equal);

}  // namespace noonmark
