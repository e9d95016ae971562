#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/receivers/receivers.h"

namespace noonmark {

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

}  // namespace noonmark
