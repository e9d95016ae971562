#include "core/bench/paper_bench.h"

#include "core/bench/engine_times.h"
#include "core/bench/experiments.h"
#include "core/bench/graph_bound.h"
#include "core/bench/graph_error.h"
#include "core/bench/level_error.h"
#include "core/bench/memory_by_resolution.h"
#include "core/bench/sun_linearity.h"
#include "core/bench/time_against_error.h"
#include "core/bench/time_by_days.h"
#include "core/bench/time_by_resolution.h"

namespace noonmark::bench {

namespace {

std::vector<SummaryFigure> paperSummary() {
    return {{"sam_vs_shadow_map", "shadow accrual map, times as fast as shadow maps", "> 10"},
            {"iam_vs_ray", "inverse accrual map, times as fast as rays", "5.3"},
            {"iam_area_error_mean_pct", "inverse accrual map, area error, mean, %", "< 1"},
            {"iam_area_error_max_pct", "inverse accrual map, area error, largest, %", "2.6"},
            {"graph_edges", "direction graph, edges of a year", "299"},
            {"graph_intervals", "direction graph, hourly intervals of a year", "2190"},
            {"graph_area_error_mean_pct", "direction graph, area error, mean, %", "0.47"},
            {"graph_mistagged_pct", "direction graph, mistagged, %", "0.8"},
            {"year_graph_speedup", "a year by graph and inverse accrual map, times as fast as rays", "> 50"}};
}

void addPeriods(Experiments& experiments, const BenchSite& site, const Extent& extent,
                const EngineList& engines, const Work& work) {
    Result<std::vector<PeriodRun>> runs;
    experiments.add("Run time against error", [&] {
        runs = periodRuns(site, extent, engines, work);
        return runs.map([&](const auto& made) { return timeAgainstError(made, extent); });
    });
    experiments.add("Time by days",
                    [&] { return runs.map([&](const auto& made) { return timeByDays(made, extent); }); });
}

void addAll(Experiments& experiments, const BenchSite& site, const Extent& extent, const EngineList& engines,
            const Work& work) {
    const StartList usual = usualEngines(engines);
    addPeriods(experiments, site, extent, engines, work);
    experiments.add("All engines over places and days",
                    [&] { return engineTimes(site, extent, usual, work); });
    experiments.add("Time by resolution", [&] { return timeByResolution(site, extent, usual, work); });
    experiments.add("Memory by resolution", [&] { return memoryByResolution(site, extent, usual, work); });
    experiments.add("Inverse accrual map: error by source level",
                    [&] { return levelError(site, extent, engines, work); });
    experiments.add("Shadows through the direction graph", [&] { return graphError(site, extent, work); });
    experiments.add("The direction graph", [&] { return graphBound(site, extent, work); });
    experiments.add("How straight the sun's path is", [&] { return sunLinearity(site, extent, work); });
    for (const std::string& absent : usual.absent) experiments.remark(absent);
}

}  // namespace

Result<BenchReport> paperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                               Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Work work{progress, stop};
    Extent fitting = extent;
    fitting.resolutions = fittingResolutions(site, extent.resolutions);
    Experiments experiments(work);
    addAll(experiments, site, fitting, engines, work);
    return std::move(experiments)
        .into({.title = "The paper's experiments, run again", .summary = paperSummary()}, site, extent);
}

}  // namespace noonmark::bench
