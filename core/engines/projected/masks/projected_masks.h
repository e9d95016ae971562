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

/// Engine::shadeSteps() with projected shadows: level ground only. The bits are those of the day's rasters
/// (computeShadowRasters()), exactly. Only casters whose shadow can reach a receiver are taken, those that
/// all cities share are filled once, and filling a place ends when it lies in shadow as a whole. Uses all
/// cores; holds the masks of a few days at a time.
Result<void> computeProjectedMasks(std::span<const City* const> cities, const Receivers& receivers,
                                   const SunSteps& sun, const TakeDay& take, Progress& progress,
                                   const std::stop_token& stop);

}  // namespace noonmark
