#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>

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

    /// The tile that a point lies in; a point on the edge of two cells lies in the eastern and northern one.
    [[nodiscard]] std::optional<std::size_t> tileAt(glm::dvec2 pointM) const {
        const double column = std::floor((pointM.x - whole.westM) / whole.cellM);
        const double row = std::floor((pointM.y - whole.southM) / whole.cellM);
        const bool inside = column >= 0 && row >= 0 && column < whole.columns && row < whole.rows;
        if (!inside) return std::nullopt;
        const std::size_t fromNorth = std::size_t(whole.rows - 1 - int(row)) / std::size_t(side);
        return fromNorth * std::size_t(columns()) + std::size_t(column) / std::size_t(side);
    }
};

}  // namespace noonmark
