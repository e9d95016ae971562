#pragma once

#include <cstdint>
#include <span>

#include "core/receivers/grid.h"

namespace noonmark {

/// One bit a cell, 64 cells a word, rows padded to whole words: a region of 800 x 800 cells takes 83 kB and
/// stays in cache.
struct BitLayout {
    int columns = 0;
    int rows = 0;
    int wordsPerRow = 0;

    explicit BitLayout(const Grid& grid)
        : columns(grid.columns), rows(grid.rows), wordsPerRow((grid.columns + 63) / 64) {}
    [[nodiscard]] std::size_t words() const { return std::size_t(rows) * std::size_t(wordsPerRow); }
    /// Words of one row, for a raster of words() words.
    [[nodiscard]] std::uint64_t* row(std::span<std::uint64_t> raster, int row) const {
        return raster.data() + std::size_t(row) * std::size_t(wordsPerRow);
    }
};

/// Sets the cells [first, end) of a row; 0 <= first < end <= columns.
inline void setRun(std::uint64_t* row, int first, int end) {
    const int firstWord = first >> 6, lastWord = (end - 1) >> 6;
    const std::uint64_t head = ~std::uint64_t{0} << (first & 63);
    const std::uint64_t tail = ~std::uint64_t{0} >> (63 - ((end - 1) & 63));
    if (firstWord == lastWord) {
        row[firstWord] |= head & tail;
        return;
    }
    row[firstWord] |= head;
    for (int word = firstWord + 1; word < lastWord; ++word) row[word] = ~std::uint64_t{0};
    row[lastWord] |= tail;
}

}  // namespace noonmark
