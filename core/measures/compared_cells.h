#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/ray/ray_scene.h"
#include "core/measures/sampled_error.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Compares an engine's field at some receivers with rays through an existing scene over all steps. The scene
/// must hold at least every building in reach of these receivers. Publishes no partial results.
Result<std::vector<ComparedCell>> compareByRays(const RayScene& scene, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowField& field,
                                                std::span<const std::uint32_t> cells, Progress& progress,
                                                const std::stop_token& stop);

}  // namespace noonmark
