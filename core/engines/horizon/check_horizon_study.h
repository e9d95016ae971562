#pragma once

#include "core/base/result.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Error if the bin width is out of range.
Result<void> checkBinWidth(double binDeg);

/// Error if a setting is out of range.
Result<void> checkSweepSettings(const HorizonSweepSettings& settings);

/// Error if a day has more steps than can be counted.
Result<void> checkHorizonDays(const SunSteps& sun);

}  // namespace noonmark
