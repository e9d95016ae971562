#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/extent.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// How much time cached shadows save in a study of one day of 6 h at every minute, gross and continuous: a
/// tower of 200 m is moved by 10 m and back, in turn with full runs of projected shadows. The edited field is
/// compared bit for bit with a fresh one before its time counts. Summary: day_edit_fraction, day_edit_ms.
Result<Finding> benchDayEdits(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
