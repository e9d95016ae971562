#pragma once

#include <optional>

#include "core/engines/api/surface_engine.h"
#include "core/engines/ray/ray_scene.h"

namespace noonmark {

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
/// surface. The scene adds the horizontal offset RayScene::asideM.
glm::vec3 placeSurfaceRayOrigin(glm::vec3 position, glm::vec3 normal);

}  // namespace noonmark
