#pragma once

#include "core/bench/finding.h"
#include "core/bench/resolution_runs.h"

namespace noonmark::bench {

/// How engines scale with the number of cells (paper, section 7, Figure b of the performance evaluation),
/// from runs that are made already.
Finding timeByResolution(const std::vector<ResolutionRun>& runs, const BenchSite& site, const Extent& extent,
                         const StartList& engines);

}  // namespace noonmark::bench
