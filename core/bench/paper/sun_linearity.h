#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// How straight the sun's path is (paper, section 4, Table 1): the cosine of the angle between the sun and
/// the direction that engines interpolate between the ends of an interval, at every minute of intervals of 5
/// minutes to 4 hours that begin at Extent::sunTimes random times with the sun up. Geometric sun, without
/// refraction.
Result<Finding> benchSunLinearity(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
