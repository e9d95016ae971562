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

/// The longest continuous shadow of one receiver, in steps. Takes bits in time order: bit k of `shadow` means
/// that step k is in shadow, bit k of `starts` that step k begins a new run (a new day, or a gap before it).
class LongestRun {
public:
    /// Adds `count` steps, 1 to 32; bits from `count` on must be 0.
    void add(std::uint32_t shadow, std::uint32_t starts, int count) {
        if (shadow == 0)
            run_ = 0;
        else if (starts == 0 && std::countr_one(shadow) == count)
            extend(std::uint32_t(count));
        else
            addRuns(shadow, starts, count);
    }

    [[nodiscard]] std::uint32_t longest() const { return longest_; }

private:
    void extend(std::uint32_t steps) {
        run_ += steps;
        longest_ = std::max(longest_, run_);
    }

    void addRuns(std::uint32_t shadow, std::uint32_t starts, int count) {
        for (int at = 0; at < count;) {
            const std::uint32_t rest = shadow >> unsigned(at);
            if ((rest & 1U) == 0) {
                run_ = 0;
                at += std::countr_zero(rest);  // 32 where nothing is left
                continue;
            }
            if ((starts >> unsigned(at) & 1U) != 0) run_ = 0;
            const int steps = std::min(std::countr_one(rest), stepsToStart(starts, at));
            extend(std::uint32_t(steps));
            at += steps;
        }
    }

    // From a step to the next that begins a run.
    static int stepsToStart(std::uint32_t starts, int at) {
        return std::countr_zero((starts >> unsigned(at)) & ~1U);
    }

    std::uint32_t run_ = 0;
    std::uint32_t longest_ = 0;
};

/// Counts the gross and continuous shadow of one receiver, in steps, from bits as LongestRun takes them.
class RunCounter {
public:
    void add(std::uint32_t shadow, std::uint32_t starts, int count) {
        total_ += std::uint32_t(std::popcount(shadow));
        runs_.add(shadow, starts, count);
    }

    [[nodiscard]] std::uint32_t total() const { return total_; }
    [[nodiscard]] std::uint32_t longest() const { return runs_.longest(); }

private:
    std::uint32_t total_ = 0;
    LongestRun runs_;
};

}  // namespace noonmark
