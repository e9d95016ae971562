#include "core/engines/common/receiver_tiles.h"
#include "core/base/safe_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>

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

FinishedTiles::FinishedTiles(const ReceiverTiles& tiles, const ShadowField& field, PartialSink* sink)
    : tiles_(tiles), field_(field), sink_(sink), done_(sink ? tiles.count() : 0) {
    if (!sink_) return;
    stride_ = chooseScatteringStride(tiles.count());
    shown_ = field;
    shown_.grossMin.assign(field.grid.size(), std::numeric_limits<float>::quiet_NaN());
    shown_.continuousMin = shown_.grossMin;
    isShown_.resize(tiles.count());
}

void FinishedTiles::finish(std::size_t tile) {
    if (!sink_) return;
    done_[tile].store(true, std::memory_order_release);
    const bool last = count_.fetch_add(1) + 1 == tiles_.count();
    if (!last && !sink_->wants()) return;
    std::unique_lock lock(deliveryMutex_, std::defer_lock);
    if (last)
        lock.lock();
    else if (!lock.try_lock())
        return;
    sink_->take(finished());
}

PartialField FinishedTiles::finished() {
    std::vector<std::uint32_t> cells;
    std::size_t count = 0;
    for (std::size_t tile = 0; tile < done_.size(); ++tile) {
        if (!done_[tile].load(std::memory_order_acquire)) continue;
        ++count;
        if (isShown_[tile]) continue;
        isShown_[tile] = true;
        tiles_.cellsOf(tile, cells);
        for (const std::uint32_t cell : cells) {
            shown_.grossMin[cell] = field_.grossMin[cell];
            shown_.continuousMin[cell] = field_.continuousMin[cell];
        }
    }
    return {shown_, double(count) / double(done_.size()),
            fmt::format("{} of {}", count, countOf(done_.size(), "tile"))};
}

}  // namespace noonmark
