#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// The error that the direction graph adds to shadows (paper, section 7, Figure a of the plots): in
/// Extent::graphHours random hours of a year of 6 h days, in random squares of the city, the ray engine with
/// the sun's own directions against the ray engine with those of the hour's edge, bound 5 deg. Summary:
/// graph_area_error_mean_pct, graph_mistagged_pct.
Result<Finding> benchGraphError(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
