#pragma once

#include <cstdint>
#include <span>

#include "core/geo/grid.h"

namespace noonmark {

/// One bit per cell, 64 cells of a row per word. Words of the same 64 columns are contiguous, row by row. A
/// region of 800 x 800 cells takes 83 kB per step. A raster may hold only the columns from a multiple of 64
/// on; columns are counted from the grid's first one all the same.
struct BitLayout {
    int columns = 0;  ///< end of the columns
    int rows = 0;
    int wordColumns = 0;
    int firstWord = 0;  ///< the first column is 64 times that

    explicit BitLayout(const Grid& grid) : BitLayout(grid.columns, grid.rows) {}
    BitLayout(int endColumn, int rowCount, int firstWordColumn = 0)
        : columns(endColumn),
          rows(rowCount),
          wordColumns((endColumn + 63) / 64 - firstWordColumn),
          firstWord(firstWordColumn) {}
    [[nodiscard]] int firstColumn() const { return firstWord * 64; }
    [[nodiscard]] std::size_t words() const { return std::size_t(wordColumns) * std::size_t(rows); }
    /// Index of the word that holds a cell, in bit column % 64.
    [[nodiscard]] std::size_t word(int column, int row) const {
        return std::size_t((column >> 6) - firstWord) * std::size_t(rows) + std::size_t(row);
    }
    [[nodiscard]] bool at(std::span<const std::uint64_t> raster, int column, int row) const {
        return (raster[word(column, row)] >> (column & 63) & 1) != 0;
    }
    void set(std::span<std::uint64_t> raster, int column, int row) const {
        raster[word(column, row)] |= std::uint64_t{1} << (column & 63);
    }
};

/// Rows [first, end) of a grid whose shadows are filled and counted together.
struct RowBand {
    int first = 0;
    int end = 0;
    [[nodiscard]] int rows() const { return end - first; }
};

/// Columns [west, east) of a band of rows; west is a multiple of 64.
struct FillWindow {
    RowBand band;
    int west = 0, east = 0;
    [[nodiscard]] BitLayout layout() const { return {east, band.rows(), west / 64}; }
};

}  // namespace noonmark
