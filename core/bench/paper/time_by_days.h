#pragma once

#include "core/bench/contests/period_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// How engines scale with the number of days (paper, section 7, Figure c of the performance evaluation), from
/// finished runs. The time of an engine that was too slow is extrapolated in proportion to the days. Summary:
/// year_graph_speedup, the ray reference's time for 365 days divided by that of the inverse accrual map with
/// the direction graph, if that was measured: the paper's "over 50X".
Finding benchTimeByDays(const std::vector<PeriodRun>& runs, const Extent& extent);

}  // namespace noonmark::bench
