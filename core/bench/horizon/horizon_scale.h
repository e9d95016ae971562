#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// How the time of the horizon sweep over a year of 8 h days grows with the number of receivers (squares of
/// an eighth to the whole side), and with the number of buildings in the city, nearest to the middle first,
/// most of them out of reach.
Result<Finding> benchHorizonScale(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
