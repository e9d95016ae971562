#include "core/engines/projected/projected_breakdown.h"

#include <new>

#include "core/base/progress_share.h"
#include "core/engines/api/blank_field.h"
#include "core/engines/common/level_ground.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/casters/projection.h"

namespace noonmark {

namespace {

Result<ShadowBreakdown> brokenDown(const City& city, const Receivers& receivers, const SunSteps& sun,
                                   const StepSets& sets, Progress& progress, const std::stop_token& stop) {
    const ShadowCasters casters =
        makeShadowCasters(city, findBuildingsInReach(city, receivers, sun), receivers.grid);
    ShadowBreakdown breakdown{receivers.grid, sets, sets.sunlitMinutes(sun), {}, {}};
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        const SunSteps own = sets.stepsOf(set, sun);
        ShadowField field = blankField(receivers, own);
        field.days = 1;  // so that minutes are totals
        ProgressShare share(progress, set, sets.names.size());
        if (const auto filled = Projection(casters, receivers, own, share, stop).run(field); !filled)
            return tl::make_unexpected(filled.error());
        breakdown.minutes.push_back(std::move(field.grossMin));
    }
    return breakdown;
}

}  // namespace

Result<ShadowBreakdown> computeProjectedBreakdown(const City& city, const Receivers& receivers,
                                                  const SunSteps& sun, const StepSets& sets,
                                                  Progress& progress, std::stop_token stop) try {
    if (const auto flat = checkLevelGround(city, receivers, "Projected shadows fall"); !flat)
        return tl::make_unexpected(flat.error());
    return brokenDown(city, receivers, sun, sets, progress, stop);
} catch (const std::bad_alloc&) {
    return failure("There is not enough memory for this study", "projected shadows",
                   "Choose a smaller region or larger cells");
}

}  // namespace noonmark
