#pragma once

#include "core/accumulate/accumulator.h"

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
/// grows), so flat ground and the terrain's own triangles do not shade their own receiver. Touching: the rule
/// of RayScene; a receiver exactly on a wall whose sun stands behind the building is in shadow, in front of
/// it lit, and exactly along the wall in shadow where the roof's edge is high enough: edges block.
class RayReference final : public Accumulator {
public:
    explicit RayReference(RayReferenceSettings settings = {});
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const override;

private:
    RayReferenceSettings settings_;
};

/// Where the rays of a receiver begin: its place on the ground, lifted.
glm::vec3 rayOrigin(glm::vec3 receiver);

}  // namespace noonmark
