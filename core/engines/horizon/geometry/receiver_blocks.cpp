#include "core/engines/horizon/geometry/receiver_blocks.h"

#include <algorithm>

namespace noonmark {

namespace {
constexpr std::size_t codesPerLine = 32;
}

ReceiverBlocks::ReceiverBlocks(const Receivers& receivers, const TileBox& box, Numbering numbering)
    : box_(box),
      numbering_(numbering),
      blockCounts_((box.columns + side - 1) / side, (box.rows + side - 1) / side) {
    for (int row = box.firstRow; row < box.firstRow + box.rows; row += side)
        for (int column = box.firstColumn; column < box.firstColumn + box.columns; column += side)
            addBlock(receivers, column, row);
}

void ReceiverBlocks::addBlock(const Receivers& receivers, int column, int row) {
    Block block{column, row, std::uint32_t(cellOf_.size()), 0};
    rowMasks_.push_back({});
    columnMasks_.push_back({});
    bool inRegion = false;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool inside = column + x < receivers.grid.columns && row + y < receivers.grid.rows;
            const std::size_t cell = inside ? receivers.grid.index(column + x, row + y) : 0;
            const CellKind kind = inside ? receivers.kind[cell] : CellKind::outside;
            inRegion |= kind != CellKind::outside;
            addCell(kind, std::uint32_t(cell), x, y);
        }
    block.count = std::uint32_t(cellOf_.size()) - block.first;
    const bool used = inRegion && block.count > 0;
    blockAt_.push_back(used ? int(blocks_.size()) : -1);
    if (used) {
        blocks_.push_back(block);
        cellOf_.resize((cellOf_.size() + codesPerLine - 1) / codesPerLine * codesPerLine, padding);
    } else {
        rowMasks_.pop_back();
        columnMasks_.pop_back();
        cellOf_.resize(block.first);
    }
    rowPlaces_.resize(cellOf_.size());
    columnPlaces_.resize(cellOf_.size());
}

void ReceiverBlocks::addCell(CellKind kind, std::uint32_t cell, int x, int y) {
    const bool receiver = isReceiver(kind);
    if (!receiver && numbering_ == Numbering::receivers) return;
    cellOf_.push_back(receiver ? cell : padding);
    rowPlaces_.push_back(std::uint8_t(y * side + x));
    columnPlaces_.push_back(std::uint8_t(x * side + y));
    if (!receiver) return;
    ++receivers_;
    rowMasks_.back()[std::size_t(y)] |= std::uint16_t(1U << unsigned(x));
    columnMasks_.back()[std::size_t(x)] |= std::uint16_t(1U << unsigned(y));
}

ReceiverBlocks::CellSlot ReceiverBlocks::findSlot(int column, int row) const {
    const int x = column - box_.firstColumn, y = row - box_.firstRow;
    const auto block = std::size_t(blockAt(x / side, y / side));
    return {block, blocks_[block].first + std::uint32_t(y % side * side + x % side), x % side, y % side};
}

void ReceiverBlocks::update(const CellSlot& slot, std::uint32_t cell, bool receiver) {
    const bool was = cellOf_[slot.number] != padding;
    cellOf_[slot.number] = receiver ? cell : padding;
    if (was == receiver) return;
    receivers_ += receiver ? std::size_t{1} : ~std::size_t{0};
    rowMasks_[slot.block][std::size_t(slot.y)] ^= std::uint16_t(1U << unsigned(slot.x));
    columnMasks_[slot.block][std::size_t(slot.x)] ^= std::uint16_t(1U << unsigned(slot.y));
}

std::vector<TileBox> splitIntoTiles(const Grid& grid, int side) {
    std::vector<TileBox> tiles;
    for (int row = 0; row < grid.rows; row += side)
        for (int column = 0; column < grid.columns; column += side)
            tiles.push_back(
                {column, row, std::min(side, grid.columns - column), std::min(side, grid.rows - row)});
    return tiles;
}

}  // namespace noonmark
