#pragma once

#include <array>

#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// The paper's experiments, run again with every engine of the list. An experiment that cannot be made here
/// becomes a finding that says why. Error: the city has no buildings, a date out of range; cancelled() soon
/// after a stop request.
Result<BenchReport> runPaperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  Progress& progress, const std::stop_token& stop);

/// The keys of its findings, in their order.
inline constexpr std::array paperBenchKeys{"time_against_error", "time_by_days",         "engine_times",
                                           "time_by_resolution", "memory_by_resolution", "level_error",
                                           "graph_error",        "graph_bound",          "sun_linearity"};

}  // namespace noonmark::bench
