#pragma once

#include "core/bench/contests/resolution_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// Memory of the engines beyond city and receivers (paper, Table 2), from finished runs: the peak of the
/// process while one engine computed the hour from noon in the middle of the city. Includes the field, and
/// the ray scene if the engine builds one.
Finding benchMemoryByResolution(const std::vector<ResolutionRun>& runs, const Extent& extent,
                                const StartList& engines);

}  // namespace noonmark::bench
