#include "core/accumulate/graph_directions.h"

#include <algorithm>

#include "core/accumulate/shadow_mask.h"

namespace noonmark {

SunSteps directionsOf(const DirectionGraph& graph) {
    SunSteps directions;
    for (const auto& edge : graph.edges)
        for (int step = 0; step < edge.sun.steps; ++step)
            directions.steps.push_back({.direction = glm::vec3(edge.sun.at(step))});
    return directions;
}

DirectionGraphSettings fitting(DirectionGraphSettings settings, double stepMinutes) {
    settings.intervalMinutes = std::min(settings.intervalMinutes, maxMaskSteps * stepMinutes);
    return settings;
}

}  // namespace noonmark
