#pragma once

#include <array>
#include <cstdint>

#include "core/engines/common/shadow_mask.h"

namespace noonmark {

/// Transposes 64 words of 64 bits: bit j of word i becomes bit i of word j. Source of the method: Warren,
/// Hacker's Delight, section 7-3.
inline void transpose(std::array<std::uint64_t, 64>& words) {
    std::uint64_t mask = 0x00000000FFFFFFFFULL;
    for (unsigned width = 32; width != 0; width >>= 1, mask ^= mask << width)
        for (unsigned i = 0; i < 64; i = ((i | width) + 1) & ~width) {
            const std::uint64_t swap = ((words[i] >> width) ^ words[i | width]) & mask;
            words[i] ^= swap << width;
            words[i | width] ^= swap;
        }
}

}  // namespace noonmark
