#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// The effect of the bin width of the direction graph over a year of 6 h days (paper, section 7): how similar
/// a direction and the direction that replaces it are, and how many edges remain of the year's hourly
/// intervals. Two replacements: the mean of all the year's directions in a bin, and the direction that the
/// edge of an interval actually uses. Summary: graph_edges, graph_intervals, at 5 deg.
Result<Finding> benchGraphBound(const BenchSite& site, const Extent& extent, const Work& work);

/// The error that the direction graph adds to shadows (paper, section 7, Figure a of the plots): in
/// Extent::graphHours random hours of a year of 6 h days, in random squares of the city, the ray engine with
/// the sun's own directions against the ray engine with those of the hour's edge, bound 5 deg. Summary:
/// graph_area_error_mean_pct, graph_mistagged_pct.
Result<Finding> benchGraphError(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
