#pragma once

#include "core/accumulate/direction_graph.h"

namespace noonmark {

/// Every direction of every edge, for IntervalEngine::prepare.
SunSteps directionsOf(const DirectionGraph& graph);

/// A step of less than a minute makes the intervals shorter: a mask holds 64 steps.
DirectionGraphSettings fitting(DirectionGraphSettings settings, double stepMinutes);

}  // namespace noonmark
