#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/horizon/day_groups.h"
#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

/// Receivers that are counted together.
inline constexpr std::size_t lanesARun = 64;

/// Horizon codes of one bin, or numbers of steps, one a receiver.
struct alignas(64) RunLanes {
    std::int16_t values[lanesARun] = {};
};

/// The longest unbroken runs in shadow over a period. Groups of days whose bound cannot beat what was found
/// are passed over; the others are walked step by step.
class LongestRuns {
public:
    /// `days`: as of alikeDays(), in whatever order; none may have more than 32,767 steps.
    LongestRuns(std::vector<TimedStep> steps, std::span<const DaySteps> days);

    /// Of each receiver, in steps. `horizons`: one a bin. O(days x bins), and more where days look alike.
    [[nodiscard]] RunLanes of(std::span<const RunLanes> horizons) const;

    /// Of one receiver, step by step: those in shadow are told by `hidden(place)`.
    template <class Hidden>
    [[nodiscard]] int ofOne(const Hidden& hidden) const {
        int run = 0, longest = 0;
        for (const TimedStep& step : steps_) {
            if (step.startsRun) run = 0;
            run = hidden(step.place) ? run + 1 : 0;
            longest = std::max(longest, run);
        }
        return longest;
    }

    [[nodiscard]] std::span<const TimedStep> steps() const { return steps_; }

private:
    struct Groups {
        DayGroup all;
        std::vector<DayGroup> roughly, each;  // its days, one by one
    };
    void walk(std::span<const RunLanes> horizons, std::span<const RunLanes> highest, const Groups& groups,
              RunLanes& longest) const;

    std::vector<TimedStep> steps_;
    std::vector<Groups> groups_;
};

}  // namespace noonmark
