#pragma once

#include "core/bench/contests/period_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// The figure that the paper lacks: every engine and setting as a point, error on one axis and time on the
/// other, for an hour, a day, a month and a year; from runs that are made already.
Finding benchTimeAgainstError(const std::vector<PeriodRun>& runs, const Extent& extent);

}  // namespace noonmark::bench
