#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace noonmark {

/// Rows of bits, one row a step: bit c of each row belongs to the same receiver.
struct BitRows {
    std::size_t words = 0;  ///< of a row
    std::vector<std::uint64_t> bits;

    [[nodiscard]] std::size_t rows() const { return words == 0 ? 0 : bits.size() / words; }
};

/// A run of set bits of one column.
struct ColumnRun {
    std::size_t row = 0;  ///< the first
    std::size_t column = 0;
    std::size_t length = 0;  ///< in rows
};

/// The longest unbroken run of set bits in any column: the earliest, and of these the first column; none
/// where no bit is set. O(bits / 64 x log length), all columns at once.
std::optional<ColumnRun> findLongestColumnRun(BitRows rows);

}  // namespace noonmark
