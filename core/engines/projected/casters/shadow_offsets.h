#pragma once

#include "core/engines/projected/filling/step_lanes.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The throws of the steps from `first` to `end`, and eight at least: the first eight one by one, the
/// period's last step again for those beyond it, and the bounds of all. Of a period that is not empty.
StepOffsets computeOffsets(const SunSteps& sun, double cellM, std::size_t first, std::size_t end);

/// The throws of the period eight by eight.
std::vector<StepOffsets> computeOffsetsByEight(const SunSteps& sun, double cellM);

}  // namespace noonmark
