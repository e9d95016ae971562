#include "core/accumulate/projected/sun_throws.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/accumulate/projected/cell_coordinates.h"

namespace noonmark {

StepThrows throwsOf(const SunSteps& sun, double cellM, std::size_t first, std::size_t end) {
    StepThrows throws{{}, glm::dvec2(1e30), glm::dvec2(-1e30)};
    for (std::size_t step = first; step < std::max(end, first + stepsTogether); ++step) {
        const glm::dvec3 towardsSun(sun.steps[std::min(step, sun.steps.size() - 1)].direction);
        const glm::dvec2 thrown = throwInCells(towardsSun, cellM);
        throws.low = glm::min(throws.low, thrown);
        throws.high = glm::max(throws.high, thrown);
        if (step - first >= stepsTogether) continue;
        throws.at.x[step - first] = thrown.x;
        throws.at.y[step - first] = thrown.y;
    }
    return throws;
}

std::vector<StepThrows> throwsByEight(const SunSteps& sun, double cellM) {
    std::vector<StepThrows> throws;
    for (std::size_t first = 0; first < sun.steps.size(); first += stepsTogether)
        throws.push_back(throwsOf(sun, cellM, first, first + stepsTogether));
    return throws;
}

}  // namespace noonmark
