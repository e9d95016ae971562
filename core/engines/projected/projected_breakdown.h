#pragma once

#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_breakdown.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Minutes in shadow by sets of steps, computed with projected shadows (projected_shadows.h: the same cities
/// and receivers). Each set has the same result as a run over its own steps, bit for bit. Buildings are
/// processed once and each step is filled once, so the cost is that of a run over the whole period plus some
/// 3 ms per set for 800 x 800 cells. `sets.ofStep`: one entry per step. Does not break down by building.
Result<ShadowBreakdown> computeProjectedBreakdown(const City& city, const Receivers& receivers,
                                                  const SunSteps& sun, const StepSets& sets,
                                                  Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
