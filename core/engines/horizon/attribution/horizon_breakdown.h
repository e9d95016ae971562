#pragma once

// Charges shadow to buildings. computeHorizonBreakdown() repeats the horizon sweep with attribution:
// attributed_block.h stores, beside each horizon, the building that makes it and the horizon without that
// building; step_sums.h finds the intervals that the overhangs of each building hide, and sums the steps of
// attributed shadow and of sole contribution.

#include <optional>
#include <string>

#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

struct BreakdownSettings {
    HorizonSweepSettings sweep;
    bool byBuilding = false;  ///< about twice the time; four times if 2 % of the parts are overhangs
};

/// Computes the breakdown with one horizon sweep (horizon_sweep.h: the same errors and refusals).
/// `sets.ofStep`: one entry per step. The sum over all sets equals the sweep's gross shadow exactly. What
/// buildings take is summed over the receivers by their shares, which are rounded to a billionth for a place
/// and a year of minutes.
Result<ShadowBreakdown> computeHorizonBreakdown(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const StepSets& sets,
                                                const BreakdownSettings& settings, Progress& progress,
                                                std::stop_token stop);

}  // namespace noonmark
