#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/day_groups.h"
#include "core/engines/horizon/counting/run_search.h"
#include "core/simd/simd_lanes.h"

namespace noonmark {

/// Receivers that are counted together.
inline constexpr std::size_t lanesPerPart = 64;

/// Horizon codes of one bin, or numbers of steps, one a receiver.
struct alignas(64) RunLanes {
    std::int16_t values[lanesPerPart] = {};
};

/// The longest unbroken runs in shadow over a period. Groups of days whose bound cannot beat what was found
/// are passed over; the others are walked step by step.
class LongestRuns {
public:
    /// `days`: as of sortDaysByDeclination(), in whatever order; none may have more than 32,767 steps.
    LongestRuns(std::vector<TimedStep> steps, std::span<const DaySteps> days);

    /// Longest runs, and of each the day that it was found on: an index for run().
    struct Found {
        RunLanes longest;
        std::array<std::uint32_t, lanesPerPart> day{};
    };
    /// Of each receiver, in steps. `horizons`: one a bin. O(days x bins), and more where days look alike.
    [[nodiscard]] Found of(std::span<const RunLanes> horizons) const;

    /// Steps [first, end) of the period.
    struct Run {
        std::uint32_t first = 0, end = 0;
    };
    /// The run of `length` steps of a lane on a day, as of() found it.
    [[nodiscard]] Run run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                          int length) const;

    /// Bit k: lane k has a run of at least wanted[k] steps. Stops looking for a lane as soon as there is one.
    [[nodiscard]] std::uint64_t reached(std::span<const RunLanes> horizons, const RunLanes& wanted) const;

    /// The most that the longest run of each lane may be in each group of days, and the groups, the longest
    /// first.
    struct Bounds {
        std::vector<RunLanes> ofGroup;
        std::vector<std::uint32_t> order;
    };
    [[nodiscard]] Bounds boundsOf(std::span<const RunLanes> horizons) const;

    /// The longest run of one lane, in steps, as `search` finds it, which was begun with its horizons.
    /// `bounds`: of the highest horizons. Days that cannot hold the longest run are passed over.
    [[nodiscard]] int searched(std::size_t lane, const Bounds& bounds, RunSearch& search) const;

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
        std::uint32_t number = 0;             // of its first day in days_
    };
    void walk(std::span<const RunLanes> horizons, std::span<const RunLanes> highest, const Groups& groups,
              Found& found) const;

    std::vector<TimedStep> steps_;
    std::vector<Groups> groups_;
    std::vector<DaySteps> days_;  // of all groups
};

}  // namespace noonmark
