#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// What kept shadows save in the study of one day of 6 h at every minute, gross and continuous: a tower of
/// 200 m moved by 10 m and back, in turn with full runs of projected shadows. The edited field is compared
/// with a fresh one, bit for bit, before its time counts. Summary: day_edit_fraction, day_edit_ms.
Result<Finding> benchDayEdits(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
