#pragma once

// Charges shadow to buildings. computeHorizonBreakdown() repeats the horizon sweep with attribution:
// attributed_block.h and attributed_tile.h store, beside each horizon, the building that makes it and the
// horizon without that building; building_gaps.h does the same for the intervals hidden by overhangs. From
// these follow the attributed shadow and the sole contribution of each building. sort_by_number.h sorts
// intervals by receiver.

#include <optional>
#include <string>

#include "core/engines/api/step_sets.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

/// Shadow of one building on the receivers, for each set of steps, minutes x m2 over the whole period.
struct BuildingShadow {
    std::uint32_t building = 0;  ///< index in City::buildings
    /// Attributed shadow: shaded cell-minutes below the horizon that the building makes, and those above it
    /// that its overhangs hide. A cell-minute shaded by several buildings is attributed to one of them. The
    /// values of all buildings and of the terrain add up to the total.
    std::vector<double> attributedMinM2;
    /// Sole contribution: cell-minutes that would be lit if only this building were removed, over the same
    /// receivers.
    std::vector<double> soleMinM2;
};

/// A period's shadow by set of steps and by building.
struct ShadowBreakdown {
    Grid grid;
    StepSets sets;
    std::vector<double> sunlitMinutes;        ///< per set
    std::vector<std::vector<float>> minutes;  ///< per set, total minutes in shadow; grid order, NaN elsewhere
    std::vector<BuildingShadow> buildings;    ///< those that shade a receiver, ascending; if byBuilding
    std::optional<BuildingShadow>
        terrain;       ///< shadow of the ground itself, if there is terrain and it shades
    std::string bins;  ///< azimuth bins of the sweep, in words
};

struct BreakdownSettings {
    HorizonSweepSettings sweep;
    bool byBuilding = false;  ///< about twice the time; four times if 2 % of the parts are overhangs
};

/// Computes the breakdown with one horizon sweep (horizon_sweep.h: the same errors and refusals).
/// `sets.ofStep`: one entry per step. The sum over all sets equals the sweep's gross shadow exactly.
Result<ShadowBreakdown> computeHorizonBreakdown(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const StepSets& sets,
                                                const BreakdownSettings& settings, Progress& progress,
                                                std::stop_token stop);

}  // namespace noonmark
