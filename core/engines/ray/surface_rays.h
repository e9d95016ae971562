#pragma once

#include <optional>

#include "core/engines/api/surface_engine.h"
#include "core/engines/ray/ray_scene.h"

namespace noonmark {

/// The ray reference on surface points: one occlusion ray per point and step through every building and the
/// terrain, packets of 16 consecutive steps. The truth that other surface engines are measured against.
/// Points that face away from the sun need no ray.
class SurfaceRays final : public SurfaceEngine {
public:
    /// How far from its surface a ray starts, along the normal, metres: wider than the rounding of a place
    /// that a ray of the view found some kilometres away.
    static constexpr float liftM = 0.01F;

    /// `scene`: all of the city that `accumulate` will be given, where it is at hand already; else each call
    /// builds its own.
    explicit SurfaceRays(std::optional<RayScene> scene = {});
    [[nodiscard]] Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                   const SunSteps& sun, Progress& progress,
                                                   std::stop_token stop) const override;

private:
    std::optional<RayScene> scene_;
};

}  // namespace noonmark
