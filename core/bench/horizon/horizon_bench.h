#pragma once

#include <array>

#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// The figures of the two exact engines against their targets: the horizon sweep over a year, with the curves
/// of error and time, projected shadows over a day, and changes on kept horizons and kept shadows. Errors as
/// in paperBench.
Result<BenchReport> runHorizonBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                    Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in their order.
inline constexpr std::array horizonBenchKeys{"horizon_year", "projected_day", "horizon_edits", "day_edits",
                                             "horizon_scale"};

}  // namespace noonmark::bench
