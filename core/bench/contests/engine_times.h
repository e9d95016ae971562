#pragma once

#include "core/bench/contests/contestant.h"
#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// All engines over random places and days (paper, section 7, Figure a of the performance evaluation):
/// Extent::hoursADay around noon, always Extent::runs runs, seconds per hourly interval, each engine's times
/// sorted separately. Summary: iam_vs_ray and sam_vs_shadow_map, the ratios of mean times if both were timed;
/// of the two forms of the shadow accrual map, the faster one on this machine.
Result<Finding> benchEngineTimes(const BenchSite& site, const Extent& extent, const StartList& engines,
                                 const Work& work);

}  // namespace noonmark::bench
