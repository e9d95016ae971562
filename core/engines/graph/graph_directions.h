#pragma once

#include "core/engines/graph/direction_graph.h"

namespace noonmark {

/// Every direction of every edge, for IntervalEngine::prepare.
SunSteps collectDirections(const DirectionGraph& graph);

/// Shortens the intervals if steps are shorter than a minute, because a mask holds 64 steps.
DirectionGraphSettings fitToMasks(DirectionGraphSettings settings, double stepMinutes);

}  // namespace noonmark
