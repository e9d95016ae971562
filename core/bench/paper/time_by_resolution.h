#pragma once

#include "core/bench/contests/resolution_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// How engines scale with the number of cells (paper, section 7, Figure b of the performance evaluation),
/// from finished runs.
Finding benchTimeByResolution(const std::vector<ResolutionRun>& runs, const BenchSite& site,
                              const Extent& extent, const StartList& engines);

}  // namespace noonmark::bench
