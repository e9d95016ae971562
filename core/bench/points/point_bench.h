#pragma once

// The folder core/bench/points measures the sweep of point receivers. runPointBench() (this file) runs its
// experiment, facade_year.h.

#include <array>

#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// Horizons of points on facades over a year, against rays. `engines` is not used. Errors as in
/// runPaperBench.
Result<BenchReport> runPointBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in order.
inline constexpr std::array pointBenchKeys{"facade_year"};

}  // namespace noonmark::bench
