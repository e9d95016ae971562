#pragma once

#include "core/base/result.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Error for a bin width out of range.
Result<void> checkBinWidth(double binDeg);

/// Error for a setting out of range.
Result<void> checkSweepSettings(const HorizonSweepSettings& settings);

/// Error for days of more steps than can be counted.
Result<void> checkHorizonDays(const SunSteps& sun);

}  // namespace noonmark
