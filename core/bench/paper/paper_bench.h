#pragma once

// The folder core/bench/paper repeats the paper's experiments. runPaperBench() (this file) runs one
// experiment per header, through Experiments (experiments.h), which divides the time budget. graph_lookup.h
// finds the edge of the direction graph for an interval.

#include <array>

#include "core/bench/bench_report.h"
#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

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
