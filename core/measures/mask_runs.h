#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace noonmark {

/// A row of bits, one row a step: bit c of each row belongs to the same receiver. The bits are those of
/// `set` that are not in `unset`.
struct BitRow {
    const std::uint64_t* set = nullptr;    ///< null: no bit is set
    const std::uint64_t* unset = nullptr;  ///< null: none
};

/// A run of set bits of one column.
struct ColumnRun {
    std::size_t row = 0;  ///< the first
    std::size_t column = 0;
    std::size_t length = 0;  ///< in rows
};

/// The longest unbroken run of set bits in any column: the earliest, and of these the first column; none
/// where no bit is set. Each row has `words` words. O(bits / 64 x log length) at most; columns without a run
/// as long as one that is known cost less.
std::optional<ColumnRun> findLongestColumnRun(std::span<const BitRow> rows, std::size_t words);

}  // namespace noonmark
