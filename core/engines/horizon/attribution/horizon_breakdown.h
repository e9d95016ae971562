#pragma once

#include <optional>
#include <string>

#include "core/engines/api/shadow_breakdown.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

struct BreakdownSettings {
    HorizonSweepSettings sweep;
    bool byBuilding = false;  ///< some twice the time; four times where 2 % of the parts hang
};

/// From one horizon sweep (horizon_sweep.h: the same errors and refusals).
/// `sets.ofStep`: one a step. The sum over all sets is the sweep's gross shadow, exactly.
Result<ShadowBreakdown> computeHorizonBreakdown(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const StepSets& sets,
                                                const BreakdownSettings& settings, Progress& progress,
                                                std::stop_token stop);

}  // namespace noonmark
