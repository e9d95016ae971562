#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// A year of 8 h days at every minute by the horizon sweep, at several bin widths, compared with the ray
/// reference on a sample of receivers; the ray reference's time for all receivers is extrapolated. Summary:
/// year_vs_ray, year_cell_error_mean_pct, year_cell_error_max_pct, at the default bin width.
Result<Finding> benchHorizonYear(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                 const Work& work);

/// How the time of the horizon sweep over a year of 8 h days grows with the number of receivers (squares of
/// an eighth to the whole side), and with the number of buildings in the city, nearest to the middle first,
/// most of them out of reach.
Result<Finding> benchHorizonScale(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
