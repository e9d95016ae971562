#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The numbered cells of a tile.
struct OverhangTile {
    TileBox box;
    std::vector<std::int32_t> numbers;      ///< of the cells of each block that has any, row by row; -1: none
    std::vector<float> groundsM;            ///< one per number, above the datum; empty: all are at the datum
    std::vector<NumberRange> blockNumbers;  ///< numbers of each block of cells (ReceiverBlocks), row by row
    std::vector<std::int32_t>
        firstOfBlock;  ///< of each of these: place of its first cell in `numbers`; -1: none

    /// Index of a block among all of the tile.
    [[nodiscard]] std::size_t indexOf(const ReceiverBlocks::Block& block) const {
        constexpr int side = ReceiverBlocks::side;
        const int columns = (box.columns + side - 1) / side;
        return std::size_t((block.row - box.firstRow) / side) * std::size_t(columns) +
               std::size_t((block.column - box.firstColumn) / side);
    }
    /// Number of a block's cell 16 x row + column.
    [[nodiscard]] std::uint32_t numberOf(const ReceiverBlocks::Block& block, int cell) const {
        return std::uint32_t(numbers[std::size_t(firstOfBlock[indexOf(block)] + cell)]);
    }

    OverhangTile() = default;
    OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

}  // namespace noonmark
