#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

namespace noonmark {

/// A regular grid of square cells, x east, y north, local metres. Arrays over it are row-major, row 0 the
/// SOUTHERNMOST; cell (column, row) has its centre at (westM + (column + 0.5) cellM, southM + (row + 0.5)
/// cellM).
struct Grid {
    double westM = 0;
    double southM = 0;
    double cellM = 1;
    int columns = 0;
    int rows = 0;

    [[nodiscard]] std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    }
    [[nodiscard]] glm::dvec2 centre(int column, int row) const {
        return {westM + (column + 0.5) * cellM, southM + (row + 0.5) * cellM};
    }
    [[nodiscard]] double eastM() const { return westM + columns * cellM; }
    [[nodiscard]] double northM() const { return southM + rows * cellM; }
    [[nodiscard]] double cellAreaM2() const { return cellM * cellM; }
    bool operator==(const Grid&) const = default;
};

}  // namespace noonmark
