#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// The cells of a tile that have numbers.
struct OverhangTile {
    TileBox box;
    std::vector<std::int32_t> numbers;      ///< row by row; -1: none
    std::vector<float> groundsM;            ///< of each number, above the datum; empty: all lie on it
    std::vector<NumberRange> blockNumbers;  ///< numbers of each square of cells (ReceiverBlocks), row by row

    /// Of a cell of a block, 16 x row + column.
    [[nodiscard]] std::uint32_t numberOf(const ReceiverBlocks::Block& block, int cell) const {
        const int column = block.column - box.firstColumn + cell % ReceiverBlocks::side,
                  row = block.row - box.firstRow + cell / ReceiverBlocks::side;
        return std::uint32_t(numbers[std::size_t(row) * std::size_t(box.columns) + std::size_t(column)]);
    }

    OverhangTile() = default;
    OverhangTile(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);
};

}  // namespace noonmark
