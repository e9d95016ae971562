#pragma once

#include "core/bench/contests/period_runs.h"
#include "core/bench/finding.h"

namespace noonmark::bench {

/// A figure that the paper lacks: every engine and setting as a point, with the error on one axis and the
/// time on the other, for an hour, a day, a month and a year; from finished runs.
Finding benchTimeAgainstError(const std::vector<PeriodRun>& runs, const Extent& extent);

}  // namespace noonmark::bench
