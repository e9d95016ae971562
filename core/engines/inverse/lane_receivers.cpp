#include "core/engines/inverse/lane_receivers.h"

namespace noonmark {

LaneReceivers::LaneReceivers(const Receivers& receivers, int marginCells) {
    const Grid& grid = receivers.grid;
    const std::size_t wideColumns = std::size_t(grid.columns) + 2 * std::size_t(marginCells);
    ofCell_.assign(wideColumns * (std::size_t(grid.rows) + 2 * std::size_t(marginCells)), none);
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        const int column = int(receivers.cells[i]) % grid.columns,
                  row = int(receivers.cells[i]) / grid.columns;
        ofCell_[std::size_t(row + marginCells) * wideColumns + std::size_t(column + marginCells)] =
            std::uint32_t(i);
    }
}

void LaneReceivers::find(const Lanes& lanes, int block,
                         std::vector<CacheLine<std::uint32_t>>& numbers) const {
    numbers.resize(std::size_t(lanes.majors()));
    const std::size_t across = lanes.cellAt(0, 1) - lanes.cellAt(0, 0);
    for (int major = 0; major < lanes.majors(); ++major) {
        auto& values = numbers[std::size_t(major)].values;
        const int firstMinor = lanes.minor(block * Lanes::perBlock, major);
        const std::uint32_t* column = &ofCell_[lanes.cellAt(major, 0)];
        for (int lane = 0; lane < Lanes::perBlock; ++lane)
            values[lane] =
                lanes.onGrid(firstMinor + lane) ? column[std::size_t(firstMinor + lane) * across] : none;
    }
}

}  // namespace noonmark
