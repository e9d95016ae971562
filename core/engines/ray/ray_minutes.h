#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/ray/ray_scene.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Minutes in shadow at one place.
struct PointMinutes {
    double gross = 0;       ///< a day, mean over the period's days
    double continuous = 0;  ///< longest unbroken run on any day
};

/// What RayReference finds at single places on the ground (local metres), by the same rays, with a scene that
/// is at hand: buildings out of reach may be in it or not. Some 10^7 rays a second and core; all cores.
/// cancelled() within 0.2 s.
Result<std::vector<PointMinutes>> traceMinutesAt(const RayScene& scene, std::span<const glm::vec3> places,
                                                 const SunSteps& sun, Progress& progress,
                                                 const std::stop_token& stop);

}  // namespace noonmark
