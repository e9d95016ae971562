#pragma once

#include <optional>
#include <string>

#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

/// What one building does to the receivers, in each set of steps, minutes x m2 of the whole period.
struct BuildingShadow {
    std::uint32_t building = 0;  ///< index in City::buildings
    /// Of the shaded cell-minutes, those below the horizon that it makes and those above that its hanging
    /// parts hide; of several that hide the same one has it. All and the terrain's add up to the total.
    std::vector<double> attributedMinM2;
    /// Cell-minutes that would be lit if only this building were gone, over the same receivers.
    std::vector<double> soleMinM2;
};

/// A period's shadow by sets of steps and by building.
struct ShadowBreakdown {
    Grid grid;
    StepSets sets;
    std::vector<double> sunlitMinutes;        ///< of each set
    std::vector<std::vector<float>> minutes;  ///< of each set: in shadow, in all; grid order, NaN elsewhere
    std::vector<BuildingShadow> buildings;    ///< those that shade a receiver, ascending; or not asked for
    std::optional<BuildingShadow>
        terrain;       ///< what the ground itself does, where there is terrain and it shades
    std::string bins;  ///< of a sweep's azimuths, in words
};

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
