#pragma once

#include "core/bench/contestant.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/site.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// What engines take beyond city and receivers (paper, Table 2): the peak of the process while one engine
/// computes the hour from noon in the middle of the city. The field, and a ray scene where an engine builds
/// one, are in it.
Result<Finding> memoryByResolution(const BenchSite& site, const Extent& extent, const StartList& engines,
                                   const Work& work);

}  // namespace noonmark::bench
