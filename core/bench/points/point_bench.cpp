#include "core/bench/points/point_bench.h"

#include "core/bench/paper/experiments.h"
#include "core/bench/points/facade_year.h"

namespace noonmark::bench {

namespace {

std::vector<SummaryFigure> pointSummary() {
    return {{"points_year_s", "100,000 facade points, a year of daylight minutes, gross, s", "<= 60"},
            targetFigure("points_vs_ray", "the same, times as fast as rays", atLeast(200)),
            {"points_with_runs_vs_ray", "the same with unbroken times", ""},
            {"points_error_mean_pct", "error of the sunlit time, mean, % of the year", ""},
            {"points_error_max_pct", "error of the sunlit time, largest, %", ""}};
}

}  // namespace

Result<BenchReport> runPointBench(const BenchSite& site, const Extent& extent, const EngineList&,
                                  Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Work work{progress, stop};
    Experiments experiments(work);
    experiments.add("A year on facades", [&](const Work& its) { return benchFacadeYear(site, extent, its); });
    return std::move(experiments)
        .into({.title = "Points on facades against rays", .reference = "target", .summary = pointSummary()},
              site, extent);
}

}  // namespace noonmark::bench
