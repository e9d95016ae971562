#include "core/accumulate/horizon/receiver_blocks.h"

#include <algorithm>

namespace noonmark {

namespace {
constexpr std::size_t codesALine = 32;
}

ReceiverBlocks::ReceiverBlocks(const Receivers& receivers, const TileBox& box) : box_(box) {
    for (int row = box.firstRow; row < box.firstRow + box.rows; row += side)
        for (int column = box.firstColumn; column < box.firstColumn + box.columns; column += side)
            addBlock(receivers, column, row);
}

void ReceiverBlocks::addBlock(const Receivers& receivers, int column, int row) {
    const int columns = std::min(side, box_.firstColumn + box_.columns - column);
    const int rows = std::min(side, box_.firstRow + box_.rows - row);
    Block block{column, row, std::uint32_t(cellOf_.size()), 0};
    rowMasks_.push_back({});
    columnMasks_.push_back({});
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const std::size_t cell = receivers.grid.index(column + x, row + y);
            if (receivers.kind[cell] == CellKind::ground) addReceiver(std::uint32_t(cell), x, y);
        }
    block.count = std::uint32_t(cellOf_.size()) - block.first;
    if (block.count == 0) {
        rowMasks_.pop_back();
        columnMasks_.pop_back();
        return;
    }
    blocks_.push_back(block);
    receivers_ += block.count;
    cellOf_.resize((cellOf_.size() + codesALine - 1) / codesALine * codesALine, padding);
    rowPlaces_.resize(cellOf_.size());
    columnPlaces_.resize(cellOf_.size());
}

void ReceiverBlocks::addReceiver(std::uint32_t cell, int x, int y) {
    rowMasks_.back()[std::size_t(y)] |= std::uint16_t(1U << unsigned(x));
    columnMasks_.back()[std::size_t(x)] |= std::uint16_t(1U << unsigned(y));
    cellOf_.push_back(cell);
    rowPlaces_.push_back(std::uint8_t(y * side + x));
    columnPlaces_.push_back(std::uint8_t(x * side + y));
}

std::vector<TileBox> tilesOf(const Grid& grid, int side) {
    std::vector<TileBox> tiles;
    for (int row = 0; row < grid.rows; row += side)
        for (int column = 0; column < grid.columns; column += side)
            tiles.push_back(
                {column, row, std::min(side, grid.columns - column), std::min(side, grid.rows - row)});
    return tiles;
}

}  // namespace noonmark
