#pragma once

#include "core/bench/contests/resolution_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// What engines take beyond city and receivers (paper, Table 2), from runs that are made already: the peak of
/// the process while one engine computed the hour from noon in the middle of the city. The field, and a ray
/// scene where an engine builds one, are in it.
Finding benchMemoryByResolution(const std::vector<ResolutionRun>& runs, const Extent& extent,
                                const StartList& engines);

}  // namespace noonmark::bench
