#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/engines/projected/filling/bit_raster.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Tests in constant time whether a rectangle of cells may contain a receiver: a summed-area table over
/// groups of 8 x 8 cells, small enough for the first-level cache.
class ReceiverCount {
public:
    explicit ReceiverCount(const Receivers& receivers);

    /// Whether a receiver's centre may lie in [low, high] (cells; any size) in rows of the band. May also be
    /// true if one lies nearby.
    [[nodiscard]] bool any(glm::dvec2 low, glm::dvec2 high, const RowBand& band) const;
    [[nodiscard]] bool any(glm::dvec2 low, glm::dvec2 high) const {
        return any(low, high, {0, rows_ * side});
    }

private:
    static constexpr int side = 8;
    [[nodiscard]] std::uint32_t& at(int column, int row) {
        return sums_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    }
    [[nodiscard]] std::uint32_t at(int column, int row) const {
        return sums_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    }

    int columns_, rows_;               // groups of cells
    std::vector<std::uint32_t> sums_;  // (columns + 1) x (rows + 1)
};

}  // namespace noonmark
