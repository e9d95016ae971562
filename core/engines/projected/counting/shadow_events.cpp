#include "core/engines/projected/counting/shadow_events.h"

namespace noonmark {

std::vector<RunStarts> findRunStarts(const SunSteps& sun) {
    std::vector<RunStarts> starts((sun.steps.size() + stepsTogether - 1) / stepsTogether, RunStarts{});
    const auto begin = [&](std::size_t step) { starts[step / stepsTogether][step % stepsTogether] = true; };
    for (const SunDay& day : sun.days)
        if (day.count > 0) begin(day.first);
    for (std::size_t step = 1; step < sun.steps.size(); ++step)
        if (sun.steps[step].slot != sun.steps[step - 1].slot + 1) begin(step);
    return starts;
}

}  // namespace noonmark
