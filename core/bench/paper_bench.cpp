#include "core/bench/paper_bench.h"

#include <fmt/format.h>

#include "core/bench/engine_times.h"
#include "core/bench/graph_bound.h"
#include "core/bench/graph_error.h"
#include "core/bench/level_error.h"
#include "core/bench/machine.h"
#include "core/bench/memory_by_resolution.h"
#include "core/bench/sun_linearity.h"
#include "core/bench/time_against_error.h"
#include "core/bench/time_by_days.h"
#include "core/bench/time_by_resolution.h"
#include "core/stopwatch.h"

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

/// The experiments in the order of the pages; after the first that was cancelled none is made.
class Experiments {
public:
    Experiments(const BenchSite& site, const Extent& extent, const EngineList& engines, const Work& work)
        : site_(site), extent_(extent), engines_(engines), work_(work) {}

    void makeAll() {
        const StartList usual = usualEngines(engines_);
        addPeriods();
        add("All engines over places and days", [&] { return engineTimes(site_, extent_, usual, work_); });
        add("Time by resolution", [&] { return timeByResolution(site_, extent_, usual, work_); });
        add("Memory by resolution", [&] { return memoryByResolution(site_, extent_, usual, work_); });
        add("Inverse accrual map: error by source level",
            [&] { return levelError(site_, extent_, engines_, work_); });
        add("Shadows through the direction graph", [&] { return graphError(site_, extent_, work_); });
        add("The direction graph", [&] { return graphBound(site_, extent_, work_); });
        add("How straight the sun's path is", [&] { return sunLinearity(site_, extent_, work_); });
        for (const std::string& absent : usual.absent)
            if (!findings_.empty()) findings_.front().remarks.push_back(absent);
    }

    std::vector<Finding> findings() && { return std::move(findings_); }

private:
    void addPeriods() {
        Result<std::vector<PeriodRun>> runs;
        add("Run time against error", [&] {
            runs = periodRuns(site_, extent_, engines_, work_);
            return runs.map([&](const auto& made) { return timeAgainstError(made, extent_); });
        });
        add("Time by days",
            [&] { return runs.map([&](const auto& made) { return timeByDays(made, extent_); }); });
    }

    static Finding failed(const char* title, const Error& error) {
        return {
            .title = title, .text = "This experiment could not be made: " + error.text(), .comparisons = {}};
    }

    void add(const char* title, const auto& make) {
        if (work_.stopped()) return;
        const Stopwatch watch;
        Result<Finding> finding = make();
        if (!finding && isCancelled(finding.error())) return;
        if (!finding) finding = failed(title, finding.error());
        finding->seconds = watch.seconds();
        findings_.push_back(std::move(*finding));
    }

    const BenchSite& site_;
    const Extent& extent_;
    const EngineList& engines_;
    const Work& work_;
    std::vector<Finding> findings_;
};

std::string siteWords(const BenchSite& site) {
    return fmt::format("{}, {} buildings; {} and its year, {}", site.name, site.city.buildings.size(),
                       textOf(site.date), site.zone);
}

Result<void> check(const BenchSite& site) {
    if (site.city.buildings.empty())
        return failure("There are no buildings to measure", site.name, "Choose a city with buildings");
    // What the experiments would all say of a wrong date or zone, said once.
    return noonHour(site).map([](const SunSteps&) {});
}

}  // namespace

Result<BenchReport> paperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                               Progress& progress, const std::stop_token& stop) {
    if (const auto fits = check(site); !fits) return tl::make_unexpected(fits.error());
    const Stopwatch watch;
    const Work work{progress, stop};
    Extent fitting = extent;
    fitting.resolutions = fittingResolutions(site, extent.resolutions);
    Experiments experiments(site, fitting, engines, work);
    experiments.makeAll();
    if (work.stopped()) return cancelled();
    BenchReport report{.title = "The paper's experiments, run again",
                       .site = siteWords(site),
                       .machine = machineWords(thisMachine()),
                       .extent = extent.words,
                       .findings = std::move(experiments).findings(),
                       .summary = paperSummary()};
    report.seconds = watch.seconds();
    fillSummary(report);
    return report;
}

}  // namespace noonmark::bench
