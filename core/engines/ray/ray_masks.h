#pragma once

#include <span>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Engine::shadeSteps() with one ray for each receiver and step, on any ground. Buildings that all cities
/// share are traced once; each city's others in a scene of their own. Some 10^7 rays a second and core.
Result<void> computeRayMasks(std::span<const City* const> cities, const Receivers& receivers,
                             const SunSteps& sun, const TakeDay& take, Progress& progress,
                             const std::stop_token& stop);

}  // namespace noonmark
