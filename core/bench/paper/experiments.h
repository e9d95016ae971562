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

/// Experiments one after the other, into a report. One that cannot be made becomes a finding that says why;
/// after one that was cancelled none is made.
class Experiments {
public:
    /// All of them are to end within `budgetS`.
    explicit Experiments(const Work& work, double budgetS = std::numeric_limits<double>::infinity())
        : work_(work), budgetS_(budgetS) {}

    using Make = std::function<Result<Finding>(const Work&)>;
    /// `share` of the budget, 0 to 1; what the experiments before it did not need comes on top, what they
    /// took too much is missing.
    void add(const char* title, const Make& make, double share = 1);
    /// What is said on the first page.
    void remark(const std::string& text);

    /// `report` with findings, machine, site, extent, time and summary filled in; or cancelled().
    Result<BenchReport> into(BenchReport report, const BenchSite& site, const Extent& extent) &&;

private:
    const Work& work_;
    double budgetS_;
    Stopwatch watch_;
    double shares_ = 0;  // of the experiments so far
    std::vector<Finding> findings_;
};

/// Whether experiments can be made at all: a city with buildings, a date and a zone that are known.
Result<void> check(const BenchSite& site);

}  // namespace noonmark::bench
