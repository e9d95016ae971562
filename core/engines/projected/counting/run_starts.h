#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/engines/projected/filling/step_lanes.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Which of eight steps begin a new run: a new day, or steps are missing before it.
using RunStarts = std::array<bool, stepsTogether>;

/// Of the steps [8 k, 8 k + 8) for every k; those beyond the period begin none.
std::vector<RunStarts> findRunStarts(const SunSteps& sun);

}  // namespace noonmark
