#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/stopwatch.h"
#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"

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

}  // namespace noonmark::bench
