#include "core/engines/horizon/counting/longest_runs.h"

namespace noonmark {

LongestRuns::Found LongestRuns::of(std::span<const RunLanes> horizons) const {
    Found found;
    for (std::uint32_t i = 0; i < days_.size(); ++i) {
        const RunLanes before = found.longest;
        walk(horizons, days_[i], found.longest);
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane)
            if (found.longest.values[lane] > before.values[lane]) found.day[lane] = i;
    }
    return found;
}

StepRun LongestRuns::run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                         int length) const {
    const DaySteps& steps = days_[day];
    std::uint32_t run = 0;
    for (std::uint32_t step = steps.first; step < steps.end; ++step) {
        const StepPlace& place = steps_[step].place;
        run = horizons[place.bin].values[lane] > place.sun ? run + 1 : 0;
        if (run == std::uint32_t(length)) return {step + 1 - run, step + 1};
    }
    return {};
}

void LongestRuns::ofEachDay(std::span<const RunLanes> horizons, std::vector<RunLanes>& longest) const {
    longest.assign(days_.size(), {});
    for (std::size_t i = 0; i < days_.size(); ++i) walk(horizons, days_[i], longest[i]);
}

int LongestRuns::searched(std::size_t lane, std::span<const RunLanes> most, RunSearch& search) const {
    std::vector<std::uint32_t> order;
    for (std::uint32_t day = 0; day < days_.size(); ++day)
        if (most[day].values[lane] > search.longest()) order.push_back(day);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::uint32_t day) { return most[day].values[lane]; });
    for (const std::uint32_t day : order) {
        if (most[day].values[lane] <= search.longest()) break;
        search.walk(days_[day]);
    }
    return search.longest();
}

}  // namespace noonmark
