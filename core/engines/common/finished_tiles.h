#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <vector>

#include "core/engines/api/partial_field.h"
#include "core/engines/common/receiver_tiles.h"

namespace noonmark {

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
    std::mutex handing_;
};

}  // namespace noonmark
