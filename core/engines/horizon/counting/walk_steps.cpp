#include "core/engines/horizon/counting/walk_steps.h"

namespace noonmark {

std::vector<TimedStep> makeTimedSteps(const SunSteps& sun, const BinnedSun& binned) {
    std::vector<TimedStep> steps(sun.steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = {binned.places[i], i == 0 || sun.steps[i].slot != sun.steps[i - 1].slot + 1};
    for (const SunDay& day : sun.days)
        if (day.count > 0) steps[day.first].startsRun = true;
    return steps;
}

std::vector<DaySteps> findDays(std::span<const TimedStep> steps) {
    std::vector<DaySteps> days;
    for (std::uint32_t step = 0; step < steps.size(); ++step) {
        if (steps[step].startsRun) days.push_back({step, step});
        days.back().end = step + 1;
    }
    return days;
}

}  // namespace noonmark
