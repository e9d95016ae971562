#include "core/engines/projected/projected_breakdown.h"

#include "core/base/progress_share.h"
#include "core/engines/api/blank_field.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/casters/projection.h"

namespace noonmark {

Result<ShadowBreakdown> computeProjectedBreakdown(const City& city, const Receivers& receivers,
                                                  const SunSteps& sun, const StepSets& sets,
                                                  Progress& progress, const std::stop_token& stop) {
    const ShadowCasters casters =
        makeShadowCasters(city, findBuildingsInReach(city, receivers, sun), receivers.grid);
    ShadowBreakdown breakdown{receivers.grid, sets, sets.sunlitMinutes(sun), receivers.cells, {}, {}, {}, {}};
    breakdown.engine = "Projected shadows: exact on flat ground, one run for all months and intervals";
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        const SunSteps own = sets.stepsOf(set, sun);
        ShadowField field = makeBlankField(receivers, own);
        field.days = 1;  // so that minutes are totals
        ProgressShare share(progress, set, sets.names.size());
        if (const auto filled = ShadowProjection(casters, receivers, own, share, stop).run(field); !filled)
            return tl::make_unexpected(filled.error());
        breakdown.minutes.push_back(valuesAt(receivers.cells, field.grossMin));
    }
    return breakdown;
}

}  // namespace noonmark
