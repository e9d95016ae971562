#include "core/engines/horizon/horizon_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/engines/api/blank_field.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/horizon/attribution/horizon_breakdown.h"
#include "core/engines/horizon/check_horizon_study.h"
#include "core/engines/horizon/counting/run_rays.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/sweep/period_sweep.h"
#include "core/engines/horizon/trees/crown_sweep.h"

namespace noonmark {

namespace {

void addDecided(const RunRays& rays, const Receivers& receivers, ShadowField& field) {
    field.cost.rays += rays.rays();
    if (rays.receivers() == 0) return;
    field.engine += fmt::format("; the longest run of {} of {} receivers decided by rays", rays.receivers(),
                                receivers.cells.size());
}

// A sum of rounded altitudes may exceed what is left of the time by a trifle.
void addTakenSteps(const ShadowField& without, const std::vector<double>& steps, ShadowField& column) {
    for (std::size_t cell = 0; cell < steps.size(); ++cell) {
        const double minutes =
            double(without.grossMin[cell]) + steps[cell] * without.stepMinutes / without.days;
        column.grossMin[cell] = float(std::min(minutes, without.sunlitMinutesPerDay));
        column.continuousMin[cell] = std::numeric_limits<float>::quiet_NaN();
    }
}

std::shared_ptr<const TreeShade> addTaken(const ShadowField& without, const PeriodSweep::TakenSteps& taken,
                                          std::size_t trees) {
    TreeShade shade = makeTreeShade(without, trees);
    addTakenSteps(without, taken.evergreen, *shade.evergreen);
    addTakenSteps(without, taken.seasonal, *shade.seasonal);
    shade.how = fmt::format(
        "Horizon sweep: the length of each path through each crown at up to {} altitudes in each azimuth "
        "bin; "
        "longest runs are not counted",
        CrownSweep::maxLevels);
    return std::make_shared<const TreeShade>(std::move(shade));
}

Result<ShadowField> sweepHorizons(const City& city, const Receivers& receivers, const SunSteps& sun,
                                  const HorizonSweepSettings& settings, Progress& progress,
                                  const std::stop_token& stop) {
    ShadowField field = makeBlankField(receivers, sun);
    if (settings.counts == ShadowCounts::gross)
        std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, sun, field.cost);
    OverhangParts overhangs;
    const WallList walls = collectStandingObstacles(city, used, receivers, overhangs);
    const auto overhanging = makeOverhangShapes(overhangs, receivers.grid, walls.datumM);
    if (!overhanging) return tl::make_unexpected(overhanging.error());
    const BinnedSun binned = binSun(sun, settings);
    field.engine = fmt::format(
        "Horizon sweep: the slope of each receiver's horizon in {}, every step of every day counted{}",
        formatText(binned), settings.counts == ShadowCounts::gross ? ", gross shadow only" : "");
    std::optional<RunRays> rays;
    if (settings.counts == ShadowCounts::grossAndRuns) {
        auto made = RunRays::over(city, used, receivers, sun, settings.checksRuns, stop);
        if (!made) return tl::make_unexpected(made.error());
        rays.emplace(*std::move(made));
    }
    const CrownScene crowns = findCrowns(city, receivers, sun);
    std::optional<CrownSweep> crownSweep;
    if (!crowns.empty()) crownSweep.emplace(crowns, binned, receivers.grid, walls.datumM);
    PeriodSweep sweep(walls, *overhanging, receivers, sun, binned, settings.counts, rays ? &*rays : nullptr,
                      progress, stop);
    if (crownSweep) sweep.weigh(&*crownSweep);
    field.cost.seconds["build"] = watch.seconds();
    if (const auto done = sweep.run(field); !done) return tl::make_unexpected(done.error());
    field.cost.skipped["prisms and solids whose shadow cannot reach a tile (each x azimuth bins)"] =
        sweep.outOfReach();
    if (rays) addDecided(*rays, receivers, field);
    if (crownSweep) field.trees = addTaken(field, sweep.takenSteps(), crowns.crowns.size());
    progress.report(1, "sweeping horizons");
    return field;
}

}  // namespace

HorizonSweep::HorizonSweep(HorizonSweepSettings settings) : settings_(settings) {}

Result<ShadowField> HorizonSweep::compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                          Progress& progress, std::stop_token stop) const {
    if (const auto able = checkSweepSettings(settings_); !able) return tl::make_unexpected(able.error());
    if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
    return sweepHorizons(city, receivers, sun, settings_, progress, stop);
}

Result<ShadowBreakdown> HorizonSweep::computeBreakdown(const City& city, const Receivers& receivers,
                                                       const SunSteps& sun, const StepSets& sets,
                                                       bool byBuilding, Progress& progress,
                                                       std::stop_token stop) const {
    return computeHorizonBreakdown(city, receivers, sun, sets, {settings_, byBuilding}, progress,
                                   std::move(stop));
}

}  // namespace noonmark
