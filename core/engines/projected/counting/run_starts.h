#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/engines/projected/filling/step_lanes.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Which of eight steps begin a new run: the first of a day, or a step after a gap.
using RunStarts = std::array<bool, stepsTogether>;

/// For the steps [8 k, 8 k + 8), for every k; steps after the end of the period begin none.
std::vector<RunStarts> findRunStarts(const SunSteps& sun);

}  // namespace noonmark
