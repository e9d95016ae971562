#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <vector>

#include "core/engines/api/partial_field.h"
#include "core/engines/common/receiver_tiles.h"

namespace noonmark {

/// Hands out what is done of a field that many threads fill tile by tile: tiles that are finished hold their
/// final values for the whole period, the others NaN. Without a sink it costs nothing.
class FinishedTiles {
public:
    /// `field` is blank yet; all three outlive this. `sink` may be null.
    FinishedTiles(const ReceiverTiles& tiles, const ShadowField& field, PartialSink* sink);

    /// The tile to work on as number `turn` of all: where somebody looks, neighbours in turn lie far from
    /// each other, so that the whole region fills evenly; else they lie side by side, which caches like.
    [[nodiscard]] std::size_t tileAt(std::size_t turn) const { return turn * stride_ % tiles_.count(); }

    /// The cells of a tile are written. From any thread, once a tile; the last one hands out the whole field.
    void finish(std::size_t tile);

private:
    [[nodiscard]] PartialField finished();

    const ReceiverTiles& tiles_;
    const ShadowField& field_;
    PartialSink* sink_;
    std::size_t stride_ = 1;
    ShadowField shown_;  // with the tiles that were handed out so far, the rest unknown
    std::vector<bool> isShown_;
    std::vector<std::atomic<bool>> done_;
    std::atomic<std::size_t> count_{0};
    std::mutex handing_;
};

}  // namespace noonmark
