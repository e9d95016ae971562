#include "core/bench/paper/paper_bench.h"

#include "core/bench/contests/engine_times.h"
#include "core/bench/paper/experiments.h"
#include "core/bench/paper/graph_bound.h"
#include "core/bench/paper/graph_error.h"
#include "core/bench/paper/level_error.h"
#include "core/bench/paper/memory_by_resolution.h"
#include "core/bench/paper/sun_linearity.h"
#include "core/bench/paper/time_against_error.h"
#include "core/bench/paper/time_by_days.h"
#include "core/bench/paper/time_by_resolution.h"

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
                const EngineList& engines) {
    Result<std::vector<PeriodRun>> runs;
    const auto against = [&](const Work& work) {
        runs = benchPeriods(site, extent, engines, work);
        return runs.map([&](const auto& made) { return benchTimeAgainstError(made, extent); });
    };
    const auto byDays = [&](const Work&) {
        return runs.map([&](const auto& made) { return benchTimeByDays(made, extent); });
    };
    experiments.add("Run time against error", against, 0.42);
    experiments.add("Time by days", byDays, 0);
}

void addResolutions(Experiments& experiments, const BenchSite& site, const Extent& extent,
                    const StartList& engines) {
    Result<std::vector<ResolutionRun>> runs;
    const auto time = [&](const Work& work) {
        runs = benchResolutions(site, extent, engines, work);
        return runs.map([&](const auto& made) { return benchTimeByResolution(made, site, extent, engines); });
    };
    const auto memory = [&](const Work&) {
        return runs.map([&](const auto& made) { return benchMemoryByResolution(made, extent, engines); });
    };
    experiments.add("Time by resolution", time, 0.2);
    experiments.add("Memory by resolution", memory, 0);
}

void addAll(Experiments& experiments, const BenchSite& site, const Extent& extent,
            const EngineList& engines) {
    const StartList usual = listDefaultEngines(engines);
    addPeriods(experiments, site, extent, engines);
    experiments.add(
        "All engines over places and days",
        [&](const Work& work) { return benchEngineTimes(site, extent, usual, work); }, 0.25);
    addResolutions(experiments, site, extent, usual);
    experiments.add(
        "Inverse accrual map: error by source level",
        [&](const Work& work) { return benchLevelError(site, extent, engines, work); }, 0.07);
    experiments.add(
        "Shadows through the direction graph",
        [&](const Work& work) { return benchGraphError(site, extent, work); }, 0.04);
    experiments.add("The direction graph",
                    [&](const Work& work) { return benchGraphBound(site, extent, work); });
    experiments.add("How straight the sun's path is",
                    [&](const Work& work) { return benchSunLinearity(site, extent, work); });
    for (const std::string& absent : usual.absent) experiments.remark(absent);
}

}  // namespace

Result<BenchReport> runPaperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Work work{progress, stop};
    Extent fitting = extent;
    fitting.resolutions = chooseResolutions(site, extent.resolutions);
    Experiments experiments(work, extent.budgetS);
    addAll(experiments, site, fitting, engines);
    return std::move(experiments)
        .into({.title = "The paper's experiments, repeated", .summary = paperSummary()}, site, extent);
}

}  // namespace noonmark::bench
