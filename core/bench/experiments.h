#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/bench/bench_report.h"
#include "core/bench/extent.h"
#include "core/bench/site.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// Experiments one after the other, into a report. One that cannot be made becomes a finding that says why;
/// after one that was cancelled none is made.
class Experiments {
public:
    explicit Experiments(const Work& work) : work_(work) {}

    void add(const char* title, const std::function<Result<Finding>()>& make);
    /// What is said on the first page.
    void remark(const std::string& text);

    /// `report` with findings, machine, site, extent, time and summary filled in; or cancelled().
    Result<BenchReport> into(BenchReport report, const BenchSite& site, const Extent& extent) &&;

private:
    const Work& work_;
    std::vector<Finding> findings_;
};

/// Whether experiments can be made at all: a city with buildings, a date and a zone that are known.
Result<void> check(const BenchSite& site);

}  // namespace noonmark::bench
