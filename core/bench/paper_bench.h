#pragma once

#include "core/accumulate/engine_list.h"
#include "core/bench/bench_report.h"
#include "core/bench/extent.h"
#include "core/bench/site.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// The paper's experiments, run again with every engine of the list. An experiment that cannot be made here
/// becomes a finding that says why. Error: the city has no buildings, a date out of range; cancelled() soon
/// after a stop request.
Result<BenchReport> paperBench(const BenchSite& site, const Extent& extent, const EngineList& engines,
                               Progress& progress, const std::stop_token& stop);

}  // namespace noonmark::bench
