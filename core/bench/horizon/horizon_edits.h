#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// How much time cached horizons save in a study of a year of 8 h days: the hours of a day are changed, and
/// one tower of 40 x 40 x 200 m is moved by 10 m and back, each against the full sweep. The edited field is
/// compared bit for bit with a fresh one. Summary: retime_fraction, edit_fraction, edit_ms (for a tower that
/// has moved before), edit_first_ms.
Result<Finding> benchHorizonEdits(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
