#include "core/engines/graph/graph_directions.h"

#include <algorithm>

#include "core/engines/common/shadow_mask.h"

namespace noonmark {

SunSteps collectDirections(const DirectionGraph& graph) {
    SunSteps directions;
    for (const auto& edge : graph.edges)
        for (int step = 0; step < edge.sun.steps; ++step)
            directions.steps.push_back({.direction = glm::vec3(edge.sun.at(step))});
    return directions;
}

DirectionGraphSettings fitToMasks(DirectionGraphSettings settings, double stepMinutes) {
    settings.intervalMinutes = std::min(settings.intervalMinutes, maxMaskSteps * stepMinutes);
    return settings;
}

}  // namespace noonmark
