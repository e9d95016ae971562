#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/finding.h"
#include "core/bench/work.h"

namespace noonmark::bench {

/// How much time cached horizons save in a study of a year of 8 h days: the hours of a day are changed, and
/// one tower of 40 x 40 x 200 m is moved by 10 m and back, each against the full sweep. The edited field is
/// compared bit for bit with a fresh one. Summary: retime_fraction, edit_fraction, edit_ms (for a tower that
/// has moved before), edit_first_ms.
Result<Finding> benchHorizonEdits(const BenchSite& site, const Extent& extent, const Work& work);

/// How much time cached shadows save in a study of one day of 6 h at every minute, gross and continuous: a
/// tower of 200 m is moved by 10 m and back, in turn with full runs of projected shadows. The edited field is
/// compared bit for bit with a fresh one before its time counts. Summary: day_edit_fraction, day_edit_ms.
Result<Finding> benchDayEdits(const BenchSite& site, const Extent& extent, const Work& work);

}  // namespace noonmark::bench
