#include "core/engines/projected/masks/dense_blocks.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace noonmark {

namespace {

constexpr std::size_t cellsAReceiver = 3;  // in a dense window at most
constexpr int smallSide = 96;              // not worth dividing further, cells
constexpr int maxSide = 192;               // so that eight rasters of a window take some 50 kB at most

struct Cell {
    int column, row;
    std::uint32_t index;
};

struct Bounds {
    int west = 1 << 30, east = -1, south = 1 << 30, north = -1;  // inclusive
    void add(const Cell& cell) {
        west = std::min(west, cell.column);
        east = std::max(east, cell.column);
        south = std::min(south, cell.row);
        north = std::max(north, cell.row);
    }
    [[nodiscard]] int columns() const { return east - west + 1; }
    [[nodiscard]] int rows() const { return north - south + 1; }
};

// `cells` in row-major order.
ReceiverBlock blockOf(const std::vector<Cell>& cells, const Bounds& box) {
    ReceiverBlock window{box.west, box.east + 1, {box.south, box.north + 1}, {}};
    for (const Cell& cell : cells) {
        auto& runs = window.runs;
        if (!runs.empty() && runs.back().row == cell.row &&
            runs.back().column + runs.back().count == cell.column)
            ++runs.back().count;
        else
            runs.push_back({cell.column, cell.row, 1, cell.index});
    }
    return window;
}

bool isBlock(std::size_t cells, const Bounds& box) {
    const int side = std::max(box.columns(), box.rows());
    const std::size_t all = std::size_t(box.columns()) * std::size_t(box.rows());
    return side <= smallSide || (side <= maxSide && all <= cellsAReceiver * cells);
}

void divide(std::vector<Cell> cells, std::vector<ReceiverBlock>& windows) {
    if (cells.empty()) return;
    Bounds box;
    for (const Cell& cell : cells) box.add(cell);
    if (isBlock(cells.size(), box)) return windows.push_back(blockOf(cells, box));
    const bool wide = box.columns() >= box.rows();
    const int middle = wide ? box.west + box.columns() / 2 : box.south + box.rows() / 2;
    const auto isLow = [&](const Cell& cell) { return (wide ? cell.column : cell.row) < middle; };
    std::vector<Cell> high;
    std::ranges::copy_if(cells, std::back_inserter(high), std::not_fn(isLow));
    std::erase_if(cells, std::not_fn(isLow));
    divide(std::move(cells), windows);
    divide(std::move(high), windows);
}

}  // namespace

std::vector<ReceiverBlock> divideIntoBlocks(const Receivers& receivers) {
    const auto columns = std::uint32_t(receivers.grid.columns);
    std::vector<Cell> cells;
    cells.reserve(receivers.cells.size());
    for (std::uint32_t i = 0; i < receivers.cells.size(); ++i)
        cells.push_back({int(receivers.cells[i] % columns), int(receivers.cells[i] / columns), i});
    std::vector<ReceiverBlock> windows;
    divide(std::move(cells), windows);
    return windows;
}

std::vector<std::uint64_t> rasterWithoutReceivers(const ReceiverBlock& window) {
    const BitLayout layout = window.layout();
    std::vector<std::uint64_t> raster(layout.words(), ~std::uint64_t{0});
    for (const ReceiverRun& run : window.runs)
        for (int column = run.column; column < run.column + run.count; ++column)
            raster[layout.word(column, run.row - window.band.first)] &= ~(std::uint64_t{1} << (column & 63));
    return raster;
}

}  // namespace noonmark
