#pragma once

#include <cstdint>
#include <vector>

namespace noonmark {

// Rows of bits in words of 64: bit k is bit k % 64 of word k / 64.
using BitRows = std::vector<std::uint64_t>;

/// The bits that are not set in `others`, which has as many words.
BitRows without(BitRows words, const BitRows& others);

/// The first bit from `bit` on that is set, or is not; the number of all bits if there is none.
std::uint32_t firstBit(const BitRows& words, std::uint32_t bit, bool set);

/// Keeps the bits with which rows of at least `length` set bits begin, or go on for so many.
void keepBeginsOfRows(BitRows& words, std::uint32_t length);

/// Length of the longest row of set bits.
std::uint32_t findLongestRow(BitRows words);

}  // namespace noonmark
