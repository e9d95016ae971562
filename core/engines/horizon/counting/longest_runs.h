#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/day_groups.h"
#include "core/engines/horizon/counting/run_bounds.h"
#include "core/engines/horizon/counting/run_search.h"

namespace noonmark {

/// Finds the longest unbroken runs in shadow over a period. Groups of days whose bound cannot exceed the
/// longest run found so far are skipped; the others are walked step by step.
class LongestRuns {
public:
    /// `days`: from sortDaysByDeclination(), in any order; none may have more than 32,767 steps.
    LongestRuns(std::vector<TimedStep> steps, std::span<const DaySteps> days);

    /// The longest run of each receiver and the day on which it was found, as an index for run().
    struct Found {
        RunLanes longest;
        std::array<std::uint32_t, lanesPerPart> day{};
    };
    /// Longest runs, in steps. `horizons`: one entry per bin. O(days x bins), more if days are similar.
    [[nodiscard]] Found of(std::span<const RunLanes> horizons) const;

    /// Steps [first, end) of the period.
    struct Run {
        std::uint32_t first = 0, end = 0;
    };
    /// The run of `length` steps of a lane on a day, as found by of().
    [[nodiscard]] Run run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                          int length) const;

    /// Bit k: lane k has a run of at least wanted[k] steps. The search for a lane stops at the first such
    /// run.
    [[nodiscard]] std::uint64_t reached(std::span<const RunLanes> horizons, const RunLanes& wanted) const;

    /// Upper bounds for the longest run of each lane in each group of days, and the groups in descending
    /// order of their bounds.
    struct Bounds {
        std::vector<RunLanes> ofGroup;
        std::vector<std::uint32_t> order;
    };
    [[nodiscard]] Bounds boundsOf(std::span<const RunLanes> horizons) const;

    /// The longest run of one lane, in steps, as found by `search`, which must have been begun with its
    /// horizons. `bounds`: from the highest horizons. Days that cannot contain the longest run are skipped.
    [[nodiscard]] int searched(std::size_t lane, const Bounds& bounds, RunSearch& search) const;

    /// The longest run of one receiver, step by step; `hidden(place)` states whether a step is in shadow.
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
        std::vector<DayGroup> days;  // the group's days, individually, with rough bounds
        std::uint32_t number = 0;    // index of its first day in days_
    };
    void walk(std::span<const RunLanes> horizons, std::span<const RunLanes> highest, const Groups& groups,
              Found& found) const;

    std::vector<TimedStep> steps_;
    std::vector<Groups> groups_;
    std::vector<DaySteps> days_;  // of all groups
};

}  // namespace noonmark
