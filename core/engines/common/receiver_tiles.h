#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/receivers/receivers.h"

namespace noonmark {

/// Receivers in small squares of the grid: neighbours see the same buildings, so what one needs is still in
/// the cache for the next. No memory of its own; holds a reference to the receivers.
class ReceiverTiles {
public:
    static constexpr int usualSide = 8;

    /// `side`: cells.
    explicit ReceiverTiles(const Receivers& receivers, int side = usualSide);

    [[nodiscard]] std::size_t count() const { return std::size_t(columns_) * std::size_t(rows_); }

    /// The receivers of one tile, south to north, west to east: up to side x side cells, often none. Replaces
    /// what is in `cells`.
    void cellsOf(std::size_t tile, std::vector<std::uint32_t>& cells) const;

private:
    const Receivers& receivers_;
    int side_;
    int columns_ = 0;  ///< of tiles
    int rows_ = 0;
};

}  // namespace noonmark
