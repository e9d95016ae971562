#include "core/accumulate/horizon_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <new>
#include <optional>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/horizon_case.h"
#include "core/accumulate/horizon/period_sweep.h"
#include "core/accumulate/horizon/run_rays.h"
#include "core/accumulate/reach.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

void addDecided(const RunRays& rays, const Receivers& receivers, ShadowField& field) {
    field.cost.rays += rays.rays();
    if (rays.receivers() == 0) return;
    field.engine += fmt::format("; the longest run of {} of {} receivers decided by rays", rays.receivers(),
                                receivers.cells.size());
}

Result<ShadowField> accumulated(const City& city, const Receivers& receivers, const SunSteps& sun,
                                const HorizonSweepSettings& settings, Progress& progress,
                                const std::stop_token& stop) {
    ShadowField field = blankField(receivers, sun);
    if (settings.counts == ShadowCounts::gross)
        std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, sun);
    OpenParts open;
    const WallList walls = standingIn(city, used, receivers, open);
    const auto hanging = openShapes(open, receivers.grid, walls.datumM);
    if (!hanging) return tl::make_unexpected(hanging.error());
    const BinnedSun binned = binnedSun(sun, settings);
    field.engine = fmt::format(
        "Horizon sweep: the slope of each receiver's horizon in {}, every step of every day counted{}",
        textOf(binned), settings.counts == ShadowCounts::gross ? ", gross shadow only" : "");
    field.cost.buildingsUsed = std::uint32_t(used.size());
    field.cost.skipped["buildings whose shadow cannot reach a receiver"] =
        city.buildings.size() - used.size();
    std::optional<RunRays> rays;
    if (settings.counts == ShadowCounts::grossAndRuns) {
        auto made = RunRays::over(city, used, receivers, sun, settings.checksRuns, stop);
        if (!made) return tl::make_unexpected(made.error());
        rays.emplace(*std::move(made));
    }
    PeriodSweep sweep(walls, *hanging, receivers, sun, binned, settings.counts, rays ? &*rays : nullptr,
                      progress, stop);
    field.cost.seconds["build"] = watch.seconds();
    if (const auto done = sweep.run(field); !done) return tl::make_unexpected(done.error());
    field.cost.skipped["prisms and solids whose shadow cannot reach a tile (each x azimuth bins)"] =
        sweep.outOfReach();
    if (rays) addDecided(*rays, receivers, field);
    progress.report(1, "sweeping horizons");
    return field;
}

}  // namespace

HorizonSweep::HorizonSweep(HorizonSweepSettings settings) : settings_(settings) {}

Result<ShadowField> HorizonSweep::accumulate(const City& city, const Receivers& receivers,
                                             const SunSteps& sun, Progress& progress,
                                             std::stop_token stop) const {
    if (const auto able = checkSweepSettings(settings_); !able) return tl::make_unexpected(able.error());
    if (const auto able = checkHorizonDays(sun); !able) return tl::make_unexpected(able.error());
    try {
        return accumulated(city, receivers, sun, settings_, progress, stop);
    } catch (const std::bad_alloc&) {
        return failure("There is not enough memory for this study", "horizon sweep",
                       "Choose a smaller region or larger cells");
    }
}

}  // namespace noonmark
