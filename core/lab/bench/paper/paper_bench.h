#pragma once

// The folder core/lab/bench/paper repeats the paper's experiments. runPaperBench() runs them one after the
// other through Experiments, which divides the time budget.

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/api/engine_registry.h"
#include "core/lab/bench/bench_report.h"
#include "core/lab/bench/contests/contest.h"
#include "core/lab/bench/contests/site.h"
#include "core/lab/bench/finding.h"
#include "core/lab/bench/work.h"

namespace noonmark::bench {

/// Runs experiments one after the other and collects them in a report. An experiment that fails becomes a
/// finding that says why; after a cancelled one, no more are run.
class Experiments {
public:
    /// All experiments together should end within `budgetS`.
    explicit Experiments(const Work& work, double budgetS = std::numeric_limits<double>::infinity())
        : work_(work), budgetS_(budgetS) {}

    using Make = std::function<Result<Finding>(const Work&)>;
    /// `share` of the budget, 0 to 1. Time that earlier experiments did not use is added, time that they
    /// overran is subtracted.
    void add(const char* title, const Make& make, double share = 1);
    /// Adds a remark to the first page.
    void remark(const std::string& text);

    /// `report` with findings, machine, site, extent, time and summary filled in; or cancelled().
    Result<BenchReport> into(BenchReport report, const BenchSite& site, const Extent& extent) &&;

private:
    const Work& work_;
    double budgetS_;
    Stopwatch watch_;
    double shares_ = 0;  // sum of the shares so far
    std::vector<Finding> findings_;
};

/// Error if no experiment is possible: the city has no buildings, or the date or zone is invalid.
Result<void> check(const BenchSite& site);

/// Repeats the paper's experiments with every engine of the list. An experiment that is not possible here
/// becomes a finding that says why. Error: the city has no buildings, a date out of range; cancelled() soon
/// after a stop request.
Result<BenchReport> runPaperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in order.
inline constexpr std::array paperBenchKeys{"time_against_error", "time_by_days",         "engine_times",
                                           "time_by_resolution", "memory_by_resolution", "level_error",
                                           "graph_error",        "graph_bound",          "sun_linearity"};

/// How straight the sun's path is (paper, section 4, Table 1): the cosine of the angle between the sun and
/// the direction that engines interpolate between the ends of an interval, at every minute of intervals of 5
/// minutes to 4 hours that begin at Extent::sunTimes random times with the sun up. Geometric sun, without
/// refraction.
Result<Finding> benchSunLinearity(const BenchSite& site, const Extent& extent, const Work& work);

/// How many source levels the inverse accrual map needs (paper, section 7, Figure b of the plots): its area
/// error against the ray reference at 1 to 6 levels in Extent::hours random hours between sunrise and sunset,
/// at random squares of the city. Summary: iam_area_error_mean_pct, iam_area_error_max_pct, at 3 levels.
Result<Finding> benchLevelError(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                const Work& work);

/// How engines scale with the number of days (paper, section 7, Figure c of the performance evaluation), from
/// finished runs. The time of an engine that was too slow is extrapolated in proportion to the days. Summary:
/// year_graph_speedup, the ray reference's time for 365 days divided by that of the inverse accrual map with
/// the direction graph, if that was measured: the paper's "over 50X".
Finding benchTimeByDays(const std::vector<PeriodRun>& runs, const Extent& extent);

/// A figure that the paper lacks: every engine and setting as a point, with the error on one axis and the
/// time on the other, for an hour, a day, a month and a year; from finished runs.
Finding benchTimeAgainstError(const std::vector<PeriodRun>& runs, const Extent& extent);

/// How engines scale with the number of cells (paper, section 7, Figure b of the performance evaluation),
/// from finished runs.
Finding benchTimeByResolution(const std::vector<ResolutionRun>& runs, const BenchSite& site,
                              const Extent& extent, const StartList& engines);

/// Memory of the engines beyond city and receivers (paper, Table 2), from finished runs: the peak of the
/// process while one engine computed the hour from noon in the middle of the city. Includes the field, and
/// the ray scene if the engine builds one.
Finding benchMemoryByResolution(const std::vector<ResolutionRun>& runs, const Extent& extent,
                                const StartList& engines);

/// The effect of the bin width of the direction graph over a year of 6 h days (paper, section 7): how similar
/// a direction and the direction that replaces it are, and how many edges remain of the year's hourly
/// intervals. Two replacements: the mean of all the year's directions in a bin, and the direction that the
/// edge of an interval actually uses. Summary: graph_edges, graph_intervals, at 5 deg.
Result<Finding> benchGraphBound(const BenchSite& site, const Extent& extent, const Work& work);

/// The error that the direction graph adds to shadows (paper, section 7, Figure a of the plots): in
/// Extent::graphHours random hours of a year of 6 h days, in random squares of the city, the ray engine with
/// the sun's own directions against the ray engine with those of the hour's edge, bound 5 deg. Summary:
/// graph_area_error_mean_pct, graph_mistagged_pct.
Result<Finding> benchGraphError(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
