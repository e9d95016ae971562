#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// How straight the sun's path is (paper, section 4, Table 1): the cosine of the angle between the sun and
/// the direction that engines interpolate between the ends of an interval, at every minute of intervals of 5
/// minutes to 4 hours that begin at Extent::sunTimes random times with the sun up. Geometric sun, without
/// refraction.
Result<Finding> benchSunLinearity(const BenchSite& site, const Extent& extent, const Work& work);

/// How many source levels the inverse accrual map needs (paper, section 7, Figure b of the plots): its area
/// error against the ray reference at 1 to 6 levels in Extent::hours random hours between sunrise and sunset,
/// at random squares of the city. Summary: iam_area_error_mean_pct, iam_area_error_max_pct, at 3 levels.
Result<Finding> benchLevelError(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                const Work& work);

}  // namespace noonmark::bench
