#pragma once

#include "core/bench/contests/period_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// How engines scale with the number of days (paper, section 7, Figure c of the performance evaluation), from
/// runs that are made already. Where an engine was too slow its time is worked out in proportion to the days.
/// Summary: year_graph_speedup, the ray reference's time for 365 days over that of the inverse accrual map
/// through the direction graph, where that was measured: the paper's "over 50X".
Finding benchTimeByDays(const std::vector<PeriodRun>& runs, const Extent& extent);

}  // namespace noonmark::bench
