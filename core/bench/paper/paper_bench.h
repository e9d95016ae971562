#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

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

// The folder core/bench/paper repeats the paper's experiments. runPaperBench() (this file) runs one
// experiment per header, through Experiments (paper_bench.h), which divides the time budget. graph_errors.cpp
// finds the edge of the direction graph for an interval.

/// Repeats the paper's experiments with every engine of the list. An experiment that is not possible here
/// becomes a finding that says why. Error: the city has no buildings, a date out of range; cancelled() soon
/// after a stop request.
Result<BenchReport> runPaperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in order.
inline constexpr std::array paperBenchKeys{"time_against_error", "time_by_days",         "engine_times",
                                           "time_by_resolution", "memory_by_resolution", "level_error",
                                           "graph_error",        "graph_bound",          "sun_linearity"};

}  // namespace noonmark::bench
