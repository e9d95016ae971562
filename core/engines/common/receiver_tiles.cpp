#include "core/engines/common/receiver_tiles.h"

#include <algorithm>

namespace noonmark {

ReceiverTiles::ReceiverTiles(const Receivers& receivers, int side)
    : receivers_(receivers),
      side_(side),
      columns_((receivers.grid.columns + side - 1) / side),
      rows_((receivers.grid.rows + side - 1) / side) {}

// The cells are in ascending order, so a tile's part of a row is found by binary search.
void ReceiverTiles::cellsOf(std::size_t tile, std::vector<std::uint32_t>& cells) const {
    const Grid& grid = receivers_.grid;
    const int firstColumn = int(tile % std::size_t(columns_)) * side_;
    const int firstRow = int(tile / std::size_t(columns_)) * side_;
    const int endColumn = std::min(firstColumn + side_, grid.columns);
    const int endRow = std::min(firstRow + side_, grid.rows);
    cells.clear();
    for (int row = firstRow; row < endRow; ++row) {
        const auto from =
            std::lower_bound(receivers_.cells.begin(), receivers_.cells.end(), grid.index(firstColumn, row));
        const auto to = std::lower_bound(from, receivers_.cells.end(), grid.index(endColumn - 1, row) + 1);
        cells.insert(cells.end(), from, to);
    }
}

}  // namespace noonmark
