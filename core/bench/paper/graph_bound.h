#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// What the bound of the direction graph's bins does over a year of 6 h days (paper, section 7): how alike a
/// direction and its stand-in are, and how many edges are left of the year's hourly intervals. Two stand-ins:
/// the mean of all the year's directions in a bin, and the direction that the edge of an interval really
/// uses. Summary: graph_edges, graph_intervals, at 5 deg.
Result<Finding> benchGraphBound(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
