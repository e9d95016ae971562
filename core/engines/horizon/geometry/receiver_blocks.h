#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/receivers/receivers.h"

namespace noonmark {

/// A rectangle of cells of a grid.
struct TileBox {
    int firstColumn = 0;
    int firstRow = 0;
    int columns = 0;
    int rows = 0;
};

/// Which cells get numbers: only receivers, or every cell of the blocks in use, so that a cell keeps its
/// number whatever is built there.
enum class Numbering { receivers, cells };

/// The receivers of a tile in blocks of 16 x 16 cells, numbered block by block and row by row within a block.
/// A block's numbers begin on a cache line of codes; unused numbers before the next block are padding. Blocks
/// entirely outside the region are left out, and so are blocks without receivers if only receivers get
/// numbers.
class ReceiverBlocks {
public:
    static constexpr int side = 16;
    static constexpr int cells = side * side;
    static constexpr std::uint32_t padding = 0xFFFFFFFF;

    struct Block {
        int column, row;      ///< of its first cell, in the grid
        std::uint32_t first;  ///< number of its first receiver; a multiple of 32
        std::uint32_t count;  ///< how many numbers, at least one
    };
    /// For each row of a block (its column, if swapped) the cells that are receivers, as bits.
    using Masks = std::array<std::uint16_t, side>;

    ReceiverBlocks(const Receivers& receivers, const TileBox& box,
                   Numbering numbering = Numbering::receivers);

    [[nodiscard]] const TileBox& box() const { return box_; }
    [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
    /// Index of the block at (column, row), counted in blocks from the tile's first; -1: none.
    [[nodiscard]] int blockAt(int column, int row) const {
        const bool inside = column >= 0 && row >= 0 && column < blockCounts_.x && row < blockCounts_.y;
        return inside ? blockAt_[std::size_t(row) * std::size_t(blockCounts_.x) + std::size_t(column)] : -1;
    }
    /// Slot of a cell, for a tile whose cells all have numbers.
    struct CellSlot {
        std::size_t block;
        std::uint32_t number;
        int x, y;  ///< position in the block
    };
    [[nodiscard]] CellSlot findSlot(int column, int row) const;
    /// Makes that cell a receiver or a non-receiver.
    void update(const CellSlot& slot, std::uint32_t cell, bool receiver);
    /// Number of block columns and rows of the tile, including blocks without receivers.
    [[nodiscard]] glm::ivec2 blockCounts() const { return blockCounts_; }
    [[nodiscard]] std::size_t receivers() const { return receivers_; }
    /// Count of numbers, including padding: a multiple of 32.
    [[nodiscard]] std::size_t numbers() const { return cellOf_.size(); }
    /// Grid cell of a number; `padding` if it is not a receiver.
    [[nodiscard]] std::uint32_t cell(std::size_t number) const { return cellOf_[number]; }
    [[nodiscard]] const Masks& masks(std::size_t block, bool swapped) const {
        return swapped ? columnMasks_[block] : rowMasks_[block];
    }
    /// For each number from a block's first on: 16 x row + position in the row.
    [[nodiscard]] const std::uint8_t* places(const Block& block, bool swapped) const {
        return (swapped ? columnPlaces_ : rowPlaces_).data() + block.first;
    }

private:
    void addBlock(const Receivers& receivers, int column, int row);
    void addCell(CellKind kind, std::uint32_t cell, int x, int y);

    TileBox box_;
    Numbering numbering_;
    glm::ivec2 blockCounts_;
    std::size_t receivers_ = 0;
    std::vector<int> blockAt_;
    std::vector<Block> blocks_;
    std::vector<Masks> rowMasks_, columnMasks_;
    std::vector<std::uint32_t> cellOf_;
    std::vector<std::uint8_t> rowPlaces_, columnPlaces_;
};

/// Tiles of up to `side` x `side` cells that cover a grid; `side`: a multiple of 16.
std::vector<TileBox> splitIntoTiles(const Grid& grid, int side);

}  // namespace noonmark
