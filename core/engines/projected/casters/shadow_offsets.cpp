#include "core/engines/projected/casters/shadow_offsets.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/engines/projected/casters/cell_coordinates.h"

namespace noonmark {

StepOffsets computeOffsets(const SunSteps& sun, double cellM, std::size_t first, std::size_t end) {
    StepOffsets throws{{}, glm::dvec2(1e30), glm::dvec2(-1e30)};
    for (std::size_t step = first; step < std::max(end, first + stepsTogether); ++step) {
        const glm::dvec3 towardsSun(sun.steps[std::min(step, sun.steps.size() - 1)].direction);
        const glm::dvec2 thrown = shadowOffsetInCells(towardsSun, cellM);
        throws.low = glm::min(throws.low, thrown);
        throws.high = glm::max(throws.high, thrown);
        if (step - first >= stepsTogether) continue;
        throws.at.x[step - first] = thrown.x;
        throws.at.y[step - first] = thrown.y;
    }
    return throws;
}

std::vector<StepOffsets> computeOffsetsByEight(const SunSteps& sun, double cellM) {
    std::vector<StepOffsets> throws;
    for (std::size_t first = 0; first < sun.steps.size(); first += stepsTogether)
        throws.push_back(computeOffsets(sun, cellM, first, first + stepsTogether));
    return throws;
}

}  // namespace noonmark
