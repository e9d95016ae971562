#pragma once

// The folder core/bench/horizon measures the two exact engines against their targets. runHorizonBench() (this
// file) runs the experiments: a year by the horizon sweep and its growth with receivers and buildings
// (horizon_year.h), a day by projected shadows (horizon_bench.cpp), and edits with cached horizons and with
// cached shadows (horizon_edits.h), which both make the same edit.

#include <array>

#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// The numbers of the two exact engines against their targets: the horizon sweep over a year, with the curves
/// of error and time; projected shadows over a day; edits with cached horizons and cached shadows. Errors as
/// in runPaperBench.
Result<BenchReport> runHorizonBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                    Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in order.
inline constexpr std::array horizonBenchKeys{"horizon_year", "projected_day", "horizon_edits", "day_edits",
                                             "horizon_scale"};

}  // namespace noonmark::bench
