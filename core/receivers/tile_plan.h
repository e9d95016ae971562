#pragma once

#include <algorithm>
#include <cstddef>

#include "core/geo/grid.h"

namespace noonmark {

/// A division of a grid into square tiles of `side` cells, counted from its NORTH-WEST corner in rows from
/// north to south, as in raster files; tiles at the eastern and southern edge may be smaller.
struct TilePlan {
    Grid whole;
    int side = 1;  ///< cells, above 0

    [[nodiscard]] int columns() const { return (whole.columns + side - 1) / side; }
    [[nodiscard]] int rows() const { return (whole.rows + side - 1) / side; }
    [[nodiscard]] std::size_t count() const { return std::size_t(columns()) * std::size_t(rows()); }

    /// The cells of tile 0 .. count() - 1.
    [[nodiscard]] Grid tile(std::size_t number) const {
        const int west = int(number % std::size_t(columns())) * side;
        const int north = whole.rows - int(number / std::size_t(columns())) * side;  // row above its first
        const int south = std::max(0, north - side);
        return {whole.westM + west * whole.cellM, whole.southM + south * whole.cellM, whole.cellM,
                std::min(side, whole.columns - west), north - south};
    }
};

}  // namespace noonmark
