#include "core/engines/points/horizons/bit_rows.h"

#include <algorithm>
#include <bit>

namespace noonmark {

namespace {

// Bit k stays set if the bit `further` on is set, too; whether any does. `further`: below 64.
bool keepBoth(BitRows& words, std::uint32_t further) {
    std::uint64_t any = 0;
    for (std::size_t word = 0; word < words.size(); ++word) {
        const std::uint64_t next = word + 1 < words.size() ? words[word + 1] : 0;
        words[word] &= words[word] >> further | (further > 0 ? next << (64 - further) : 0);
        any |= words[word];
    }
    return any != 0;
}

}  // namespace

BitRows without(BitRows words, const BitRows& others) {
    for (std::size_t word = 0; word < words.size(); ++word) words[word] &= ~others[word];
    return words;
}

std::uint32_t firstBit(const BitRows& words, std::uint32_t bit, bool set) {
    for (std::size_t word = bit / 64; word < words.size(); ++word) {
        std::uint64_t some = set ? words[word] : ~words[word];
        if (word == bit / 64) some &= ~0ULL << (bit % 64);
        if (some != 0) return std::uint32_t(word * 64 + std::size_t(std::countr_zero(some)));
    }
    return std::uint32_t(words.size() * 64);
}

void keepBeginsOfRows(BitRows& words, std::uint32_t length) {
    for (std::uint32_t kept = 1; kept < length;) {
        const std::uint32_t further = std::min({kept, length - kept, 63U});
        if (!keepBoth(words, further)) return;
        kept += further;
    }
}

std::uint32_t findLongestRow(BitRows words) {
    std::uint32_t length = std::ranges::any_of(words, [](std::uint64_t word) { return word != 0; }) ? 1 : 0;
    while (length > 0 && keepBoth(words, 1)) ++length;
    return length;
}

}  // namespace noonmark
