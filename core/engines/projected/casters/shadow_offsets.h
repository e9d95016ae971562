#pragma once

#include "core/engines/projected/filling/step_lanes.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Offsets for the steps from `first` to `end`: the first eight individually, with the period's last step
/// repeated if there are fewer, and the bounds of all. The period must not be empty.
StepOffsets computeOffsets(const SunSteps& sun, double cellM, std::size_t first, std::size_t end);

/// Offsets of the period in groups of eight steps.
std::vector<StepOffsets> computeOffsetsByEight(const SunSteps& sun, double cellM);

}  // namespace noonmark
