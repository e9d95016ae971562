#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/run_search.h"
#include "core/engines/horizon/counting/walk_steps.h"

namespace noonmark {

/// Steps [first, end) of the period, all of one day.
struct StepRun {
    std::uint32_t first = 0, end = 0;
    [[nodiscard]] int length() const { return int(end - first); }
};

/// Finds the longest unbroken runs in shadow over a period, day by day: 64 receivers walk every step
/// together, in less time than it takes to find out which days need not be walked.
class LongestRuns {
public:
    /// No day may have more than 32,767 steps.
    explicit LongestRuns(std::vector<TimedStep> steps) : steps_(std::move(steps)), days_(findDays(steps_)) {}

    /// The longest run of each receiver and the day on which it was found, as an index for run().
    struct Found {
        RunLanes longest;
        std::array<std::uint32_t, lanesPerPart> day{};
    };
    /// Longest runs, in steps. `horizons`: one entry per bin. 1 ns a step.
    [[nodiscard]] Found of(std::span<const RunLanes> horizons) const;

    /// The run of `length` steps of a lane on a day, as found by of().
    [[nodiscard]] StepRun run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                              int length) const;

    /// The longest run of each lane on each day, in steps.
    void ofEachDay(std::span<const RunLanes> horizons, std::vector<RunLanes>& longest) const;

    /// The longest run of one lane, in steps, as found by `search`, which must have been begun with its
    /// horizons. `most`: upper bounds, from ofEachDay(); days that cannot contain the longest run are
    /// skipped.
    [[nodiscard]] int searched(std::size_t lane, std::span<const RunLanes> most, RunSearch& search) const;

    /// The longest run of one receiver, step by step; `hidden(place)` states whether a step is in shadow.
    template <class Hidden>
    [[nodiscard]] StepRun ofOne(const Hidden& hidden) const {
        StepRun run, longest;
        for (std::uint32_t step = 0; step < steps_.size(); ++step) {
            const bool isHidden = hidden(steps_[step].place);
            if (!isHidden || steps_[step].startsRun) run.first = isHidden ? step : step + 1;
            run.end = step + 1;
            if (run.length() > longest.length()) longest = run;
        }
        return longest;
    }

    [[nodiscard]] std::span<const TimedStep> steps() const { return steps_; }

private:
    void walk(std::span<const RunLanes> horizons, const DaySteps& day, RunLanes& longest) const {
        walkSteps(horizons, steps().subspan(day.first, day.end - day.first), longest);
    }

    std::vector<TimedStep> steps_;
    std::vector<DaySteps> days_;
};

}  // namespace noonmark
