#pragma once

// The folder core/lab/bench/points measures the sweep of point receivers. runPointBench() (this file) runs
// its experiment, benchFacadeYear().

#include <array>

#include "core/engines/api/engine_registry.h"
#include "core/lab/bench/bench_report.h"
#include "core/lab/bench/contests/site.h"
#include "core/lab/bench/finding.h"
#include "core/lab/bench/work.h"
#include "core/receivers/point_receivers.h"

namespace noonmark::bench {

/// Up to 100,000 points on the facades of the whole city, every minute from sunrise to sunset of the site's
/// year, by the sweep with and without unbroken times; rays on a sample of a tenth of
/// `extent.sampleReceivers`, from which the time of all is extrapolated. Summary: points_year_s,
/// points_vs_ray, points_with_runs_vs_ray, points_error_mean_pct, points_error_max_pct.
Result<Finding> benchFacadeYear(const BenchSite& site, const Extent& extent, const Work& work);

/// `count` of the points, or all, at equal distances in the list: neighbours stay neighbours.
SurfacePoints thinOut(const SurfacePoints& all, std::size_t count);

/// Horizons of points on facades over a year, against rays. `engines` is not used. Errors as in
/// runPaperBench.
Result<BenchReport> runPointBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in order.
inline constexpr std::array pointBenchKeys{"facade_year"};

}  // namespace noonmark::bench
