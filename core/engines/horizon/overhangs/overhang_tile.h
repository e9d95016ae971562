#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The numbered cells of a tile.
struct OverhangTile {
    TileBox box;
    std::vector<std::int32_t> numbers;      ///< row by row; -1: none
    std::vector<float> groundsM;            ///< one per number, above the datum; empty: all are at the datum
    std::vector<NumberRange> blockNumbers;  ///< numbers of each block of cells (ReceiverBlocks), row by row

    /// Number of a block's cell 16 x row + column.
    [[nodiscard]] std::uint32_t numberOf(const ReceiverBlocks::Block& block, int cell) const {
        const int column = block.column - box.firstColumn + cell % ReceiverBlocks::side,
                  row = block.row - box.firstRow + cell / ReceiverBlocks::side;
        return std::uint32_t(numbers[std::size_t(row) * std::size_t(box.columns) + std::size_t(column)]);
    }

    OverhangTile() = default;
    OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

}  // namespace noonmark
