#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// What kept horizons save in the study of a year of 8 h days: the hours of a day changed, and one tower of
/// 40 x 40 x 200 m moved by 10 m and back, each against the full sweep. The edited field is compared with a
/// fresh one, bit for bit. Summary: retime_fraction, edit_fraction, edit_ms (of a tower that has moved
/// before), edit_first_ms.
Result<Finding> benchHorizonEdits(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
