#include "core/measures/mask_runs.h"

#include <algorithm>
#include <bit>

namespace noonmark {

namespace {

bool anyBit(const BitRows& rows) {
    return std::ranges::any_of(rows.bits, [](std::uint64_t word) { return word != 0; });
}

// Row r of the result is row r of `a` and row r + by of `b`.
BitRows both(const BitRows& a, const BitRows& b, std::size_t by) {
    const std::size_t rows = b.rows() > by ? std::min(a.rows(), b.rows() - by) : 0;
    BitRows result{a.words, std::vector<std::uint64_t>(rows * a.words)};
    const std::uint64_t* other = b.bits.data() + by * b.words;
    for (std::size_t i = 0; i < result.bits.size(); ++i) result.bits[i] = a.bits[i] & other[i];
    return result;
}

ColumnRun firstIn(const BitRows& starts, std::size_t length) {
    const auto word = std::ranges::find_if(starts.bits, [](std::uint64_t bits) { return bits != 0; });
    const auto at = std::size_t(word - starts.bits.begin());
    return {at / starts.words, at % starts.words * 64 + std::size_t(std::countr_zero(*word)), length};
}

}  // namespace

// Rows where runs of 1, 2, 4, ... begin, as long as there are any; then the length is put together from the
// longest of these downwards.
std::optional<ColumnRun> findLongestColumnRun(BitRows rows) {
    if (!anyBit(rows)) return std::nullopt;
    std::vector<BitRows> powers{std::move(rows)};
    while (true) {
        BitRows twice = both(powers.back(), powers.back(), std::size_t{1} << (powers.size() - 1));
        if (!anyBit(twice)) break;
        powers.push_back(std::move(twice));
    }
    BitRows starts = powers.back();
    std::size_t length = std::size_t{1} << (powers.size() - 1);
    for (std::size_t power = powers.size() - 1; power-- > 0;) {
        BitRows longer = both(starts, powers[power], length);
        if (!anyBit(longer)) continue;
        starts = std::move(longer);
        length += std::size_t{1} << power;
    }
    return firstIn(starts, length);
}

}  // namespace noonmark
