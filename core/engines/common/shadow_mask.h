#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace noonmark {

/// Shadow of one receiver over up to 64 steps: bit k is set when step k is in shadow.
using ShadowMask = std::uint64_t;
inline constexpr int maxMaskSteps = 64;

/// The figures of a mask of `steps` bits that stitching needs (paper, section 6); all counts in steps, 0 to
/// `steps`.
struct MaskRuns {
    std::uint8_t gross = 0;
    std::uint8_t longest = 0;
    std::uint8_t prefix = 0;  ///< length of the run that begins at the first step
    std::uint8_t suffix = 0;  ///< length of the run that ends at the last step
    bool operator==(const MaskRuns&) const = default;
};

/// A mask with the lowest `steps` bits set; `steps` 0 to 64.
constexpr ShadowMask fullMask(int steps) { return steps == 0 ? 0 : ~ShadowMask{0} >> (maxMaskSteps - steps); }

/// Length of the longest run of set bits. Combines masks of the starts of runs of 32, 16, ... 1 bits, longest
/// first: twelve operations for any mask.
constexpr int findLongestRun(ShadowMask mask) {
    ShadowMask starts[6] = {mask};  // bit k of starts[i]: a run of 2^i bits begins at k
    for (int i = 1; i < 6; ++i) starts[i] = starts[i - 1] & starts[i - 1] >> (1 << (i - 1));
    int length = 0;
    ShadowMask found = ~ShadowMask{0};  // bit k: `length` bits from k on are set
    for (int i = 5; i >= 0; --i) {
        const ShadowMask longer = found & starts[i] >> length;
        if (longer == 0) continue;
        found = longer;
        length += 1 << i;
    }
    return length == 63 && mask == ~ShadowMask{0} ? 64 : length;
}

/// `mask` must have no bits set at or above bit `steps`.
constexpr MaskRuns measureRuns(ShadowMask mask, int steps) {
    if (mask == 0) return {};
    const int prefix = std::countr_one(mask);
    const int suffix = std::countl_one(mask << (maxMaskSteps - steps));
    const int longest = prefix == steps ? steps : findLongestRun(mask);
    return {std::uint8_t(std::popcount(mask)), std::uint8_t(longest), std::uint8_t(prefix),
            std::uint8_t(std::min(suffix, steps))};
}

}  // namespace noonmark
