#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace noonmark {

/// Counts the gross and continuous shadow of one receiver, in steps. Takes bits in time order: bit k of
/// `shadow` means that step k is in shadow, bit k of `starts` that step k begins a new run (a new day, or a
/// gap before it).
class RunCounter {
public:
    /// Adds `count` steps, 1 to 32; bits from `count` on must be 0.
    void add(std::uint32_t shadow, std::uint32_t starts, int count) {
        total_ += std::uint32_t(std::popcount(shadow));
        if (shadow == 0)
            run_ = 0;
        else if (starts == 0 && std::popcount(shadow) == count)
            extend(std::uint32_t(count));
        else
            addOneByOne(shadow, starts, count);
    }

    [[nodiscard]] std::uint32_t total() const { return total_; }
    [[nodiscard]] std::uint32_t longest() const { return longest_; }

private:
    void extend(std::uint32_t steps) {
        run_ += steps;
        longest_ = std::max(longest_, run_);
    }

    void addOneByOne(std::uint32_t shadow, std::uint32_t starts, int count) {
        for (int k = 0; k < count; ++k) {
            const std::uint32_t step = 1U << unsigned(k);
            if ((starts & step) != 0 || (shadow & step) == 0) run_ = 0;
            if ((shadow & step) != 0) extend(1);
        }
    }

    std::uint32_t total_ = 0;
    std::uint32_t run_ = 0;
    std::uint32_t longest_ = 0;
};

}  // namespace noonmark
