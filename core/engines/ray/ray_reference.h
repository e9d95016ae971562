#pragma once

#include "core/engines/api/engine.h"

namespace noonmark {

struct RayReferenceSettings {
    /// Height above the ground where a ray starts, metres: prevents the terrain's own triangles from blocking
    /// it.
    static constexpr float liftM = 0.001F;
    int threads = 0;  ///< 0, or more than the machine has: all cores
};

/// The reference of every error figure: one occlusion ray per receiver and step, traced by Embree in robust
/// mode, in packets of 16 consecutive steps. Supports any surface and any mesh. Cost: receivers x steps /
/// (some 10^7 per second and core).
///
/// Ground: a ray starts `liftM` above it, so that flat ground and the terrain's own triangles do not shade
/// their own receiver. More than 8 km from the origin the lift grows in proportion, as float32 resolution
/// gets coarser.
///
/// Edges are half-open, as in `contains`: a receiver exactly on a line counts as just east and north of it
/// (RayScene::wallOffsetM). A receiver on a wall is therefore lit if the sun is in front of the wall and dark
/// if the sun is behind the building. If the sun is in line with the wall, the receiver is lit on an eastern
/// or northern wall and dark on a western or southern one. Between two buildings that share a wall no light
/// passes. The result does not depend on the number of threads, nor on buildings out of reach.
class RayReference final : public Engine {
public:
    explicit RayReference(RayReferenceSettings settings = {});
    [[nodiscard]] std::string_view name() const override { return "Ray reference"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{.terrain = true,
                                             .roofs = true,
                                             .stepMasks = true,
                                             .trees = true,
                                             .independence = Independence::always};

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;
    [[nodiscard]] Result<void> computeStepMasks(std::span<const City* const> cities,
                                                const Receivers& receivers, const SunSteps& sun,
                                                const TakeDay& take, Progress& progress,
                                                std::stop_token stop) const override;

private:
    RayReferenceSettings settings_;
};

/// The origin of a receiver's rays: its position on the ground, lifted. The scene adds the horizontal offset
/// RayScene::wallOffsetM.
glm::vec3 placeRayOrigin(glm::vec3 receiver);

}  // namespace noonmark
