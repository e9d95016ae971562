#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/api/engine.h"
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

/// The ray reference for surface points: one occlusion ray per point and step against all buildings and the
/// terrain, in packets of 16 consecutive steps. Other surface engines are measured against it. Points that
/// face away from the sun need no ray.
class SurfaceRays final : public SurfaceEngine {
public:
    /// Distance along the normal at which a ray starts from its surface, metres: larger than the rounding of
    /// a position found by a view ray some kilometres long.
    static constexpr float liftM = 0.01F;

    /// `scene`: the complete city that will be passed to `accumulate`, if the caller already has it;
    /// otherwise each call builds its own.
    explicit SurfaceRays(std::optional<RayScene> scene = {});
    [[nodiscard]] Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                   const SunSteps& sun, Progress& progress,
                                                   std::stop_token stop) const override;

private:
    std::optional<RayScene> scene_;
};

/// The origin of the rays from a surface: the place, lifted off the ground (placeRayOrigin) and off the
/// surface. The scene adds the horizontal offset RayScene::wallOffsetM.
glm::vec3 placeSurfaceRayOrigin(glm::vec3 position, glm::vec3 normal);

}  // namespace noonmark
