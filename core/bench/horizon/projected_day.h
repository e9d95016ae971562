#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"
#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// One day of 6 h at every minute by every engine, in turn with the ray reference; projected shadows also
/// minute by minute. Summary: day_vs_ray and day_mistagged_pct, the share of cells and minutes in which
/// projected shadows and rays differ.
Result<Finding> benchProjectedDay(const BenchSite& site, const Extent& extent, const EngineList& engines,
                                  const Work& work);

}  // namespace noonmark::bench
