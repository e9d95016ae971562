#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A stride such that k x stride modulo `count`, for k = 0, 1, 2, ..., visits every number below `count`
/// once, with consecutive numbers far apart: near the golden section of `count` and coprime to it. 1 for
/// counts up to 2.
constexpr std::size_t chooseScatteringStride(std::size_t count) {
    std::size_t stride = count * 618 / 1000;
    if (stride == 0) stride = 1;
    while (std::gcd(stride, count) > 1) ++stride;
    return stride;
}

/// Divides receivers into small square tiles of the grid. Neighbouring receivers see the same buildings, so
/// data that one loads is still in the cache for the next. Stores no cells; holds a reference to the
/// receivers.
class ReceiverTiles {
public:
    static constexpr int defaultSide = 8;

    /// `side`: in cells.
    explicit ReceiverTiles(const Receivers& receivers, int side = defaultSide);

    [[nodiscard]] std::size_t count() const { return std::size_t(columns_) * std::size_t(rows_); }

    /// The receivers of one tile, south to north and west to east: up to side x side cells, often none.
    /// Replaces the contents of `cells`.
    void cellsOf(std::size_t tile, std::vector<std::uint32_t>& cells) const;

private:
    const Receivers& receivers_;
    int side_;
    int columns_ = 0;  ///< number of tile columns
    int rows_ = 0;
};

/// Delivers running results of a field that several threads fill tile by tile. Finished tiles hold their
/// final values for the whole period, the others NaN. Without a sink it costs nothing.
class FinishedTiles {
public:
    /// `field` must still be blank; all three must outlive this object. `sink` may be null.
    FinishedTiles(const ReceiverTiles& tiles, const ShadowField& field, PartialSink* sink);

    /// The tile to process at position `turn` of the order. With a sink, consecutive tiles lie far apart, so
    /// that the region fills evenly; without one they are adjacent, which is better for the cache.
    [[nodiscard]] std::size_t tileAt(std::size_t turn) const { return turn * stride_ % tiles_.count(); }

    /// Reports that a tile's cells are written. Call once per tile, from any thread; the last call delivers
    /// the complete field.
    void finish(std::size_t tile);

private:
    [[nodiscard]] PartialField finished();

    const ReceiverTiles& tiles_;
    const ShadowField& field_;
    PartialSink* sink_;
    std::size_t stride_ = 1;
    ShadowField shown_;  // holds the tiles delivered so far; the rest is NaN
    std::vector<bool> isShown_;
    std::vector<std::atomic<bool>> done_;
    std::atomic<std::size_t> count_{0};
    std::mutex deliveryMutex_;
};

}  // namespace noonmark
