#pragma once

#include "core/bench/contests/contest_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// How engines scale with the number of days (paper, section 7, Figure c of the performance evaluation), from
/// finished runs. The time of an engine that was too slow is extrapolated in proportion to the days. Summary:
/// year_graph_speedup, the ray reference's time for 365 days divided by that of the inverse accrual map with
/// the direction graph, if that was measured: the paper's "over 50X".
Finding benchTimeByDays(const std::vector<PeriodRun>& runs, const Extent& extent);

/// A figure that the paper lacks: every engine and setting as a point, with the error on one axis and the
/// time on the other, for an hour, a day, a month and a year; from finished runs.
Finding benchTimeAgainstError(const std::vector<PeriodRun>& runs, const Extent& extent);

/// How engines scale with the number of cells (paper, section 7, Figure b of the performance evaluation),
/// from finished runs.
Finding benchTimeByResolution(const std::vector<ResolutionRun>& runs, const BenchSite& site,
                              const Extent& extent, const StartList& engines);

/// Memory of the engines beyond city and receivers (paper, Table 2), from finished runs: the peak of the
/// process while one engine computed the hour from noon in the middle of the city. Includes the field, and
/// the ray scene if the engine builds one.
Finding benchMemoryByResolution(const std::vector<ResolutionRun>& runs, const Extent& extent,
                                const StartList& engines);

}  // namespace noonmark::bench
