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

/// Minutes in shadow at one point.
struct PointMinutes {
    double gross = 0;       ///< per day, mean over the period's days
    double continuous = 0;  ///< longest unbroken run on any day
};

/// Minutes in shadow at single points on the ground (local metres), from the same rays as RayReference
/// traces, in an existing scene; the scene may contain buildings out of reach. Some 10^7 rays per second and
/// core; uses all cores. Returns cancelled() within 0.2 s of a stop request.
Result<std::vector<PointMinutes>> traceMinutesAt(const RayScene& scene, std::span<const glm::vec3> places,
                                                 const SunSteps& sun, Progress& progress,
                                                 const std::stop_token& stop);

}  // namespace noonmark
