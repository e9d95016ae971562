#pragma once

#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_breakdown.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Minutes in shadow by sets of steps, by projected shadows (projected_shadows.h: the same cities and
/// receivers): each set has what a run over its own steps gives, bit for bit. The buildings are looked at
/// once, and each step is filled once: as a run over the whole period, and some 3 ms a set of 800 x 800
/// cells. `sets.ofStep`: one a step. Without figures of buildings.
Result<ShadowBreakdown> computeProjectedBreakdown(const City& city, const Receivers& receivers,
                                                  const SunSteps& sun, const StepSets& sets,
                                                  Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
