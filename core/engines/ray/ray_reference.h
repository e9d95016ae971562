#pragma once

#include "core/engines/api/engine.h"

namespace noonmark {

struct RayReferenceSettings {
    /// How far above the ground a ray starts, metres: keeps a receiver out of the terrain's own triangles.
    static constexpr float liftM = 0.001F;
    int threads = 0;  ///< 0, or more than there are: all cores
};

/// The truth of every error figure: one occlusion ray per receiver and step, Embree, robust, packets of 16
/// consecutive steps. Any surface, any mesh. Cost: receivers x steps / (some 10^7 a second and core).
///
/// Ground: a ray starts `liftM` above it (more than 8 km from the origin in proportion: a float's grain
/// grows), so flat ground and the terrain's own triangles do not shade their own receiver.
///
/// Edges are half-open, as in `contains`: a receiver exactly on a line counts as just east and north of it
/// (RayScene::asideM).
/// So on a wall it is lit by a sun before the wall and dark with the sun behind the building; in line with
/// an eastern or northern wall and the sun it is lit, with a western or southern one dark; between two
/// buildings that share a wall no light passes. The answer does not depend on the number of threads, nor on
/// buildings out of reach.
class RayReference final : public Engine {
public:
    explicit RayReference(RayReferenceSettings settings = {});
    [[nodiscard]] std::string_view name() const override { return "Ray reference"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{
        .terrain = true, .roofs = true, .independence = Independence::always};

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;

private:
    RayReferenceSettings settings_;
};

/// Where the rays of a receiver begin: its place on the ground, lifted. The scene moves it aside.
glm::vec3 placeRayOrigin(glm::vec3 receiver);

}  // namespace noonmark
