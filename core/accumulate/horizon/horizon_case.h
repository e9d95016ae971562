#pragma once

#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "core/result.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Whether horizons can answer: error for a bin width out of range, and for terrain.
Result<void> checkHorizonCase(const City& city, const Receivers& receivers, double binDeg);

/// Error for days of more steps than can be counted.
Result<void> checkHorizonDays(const SunSteps& sun);

}  // namespace noonmark
