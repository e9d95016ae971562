#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace noonmark {

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
