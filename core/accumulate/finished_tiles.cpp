#include "core/accumulate/finished_tiles.h"

#include <fmt/format.h>

#include <limits>

#include "core/accumulate/scattered_order.h"

namespace noonmark {

FinishedTiles::FinishedTiles(const ReceiverTiles& tiles, const ShadowField& field, PartialSink* sink)
    : tiles_(tiles), field_(field), sink_(sink), done_(sink ? tiles.count() : 0) {
    if (!sink_) return;
    stride_ = scatteringStride(tiles.count());
    nothing_ = field;
    nothing_.grossMin.assign(field.grid.size(), std::numeric_limits<float>::quiet_NaN());
    nothing_.continuousMin = nothing_.grossMin;
}

void FinishedTiles::finish(std::size_t tile) {
    if (!sink_) return;
    done_[tile].store(true, std::memory_order_release);
    const bool last = count_.fetch_add(1) + 1 == tiles_.count();
    if (!last && !sink_->wants()) return;
    std::unique_lock lock(handing_, std::defer_lock);
    if (last)
        lock.lock();
    else if (!lock.try_lock())
        return;
    sink_->take(finished());
}

PartialField FinishedTiles::finished() const {
    PartialField partial{nothing_, 0, {}};
    std::vector<std::uint32_t> cells;
    std::size_t count = 0;
    for (std::size_t tile = 0; tile < done_.size(); ++tile) {
        if (!done_[tile].load(std::memory_order_acquire)) continue;
        ++count;
        tiles_.cellsOf(tile, cells);
        for (const std::uint32_t cell : cells) {
            partial.field.grossMin[cell] = field_.grossMin[cell];
            partial.field.continuousMin[cell] = field_.continuousMin[cell];
        }
    }
    partial.share = double(count) / double(done_.size());
    partial.part = fmt::format("{} of {} tiles", count, done_.size());
    return partial;
}

}  // namespace noonmark
