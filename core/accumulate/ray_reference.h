#pragma once

#include "core/accumulate/accumulator.h"

namespace noonmark {

struct RayReferenceSettings {
    /// How far above the ground a ray starts, metres: keeps a receiver out of the terrain's own triangles.
    static constexpr float liftM = 0.001F;
    int threads = 0;  ///< 0 = all cores
};

/// The truth of every error figure: one occlusion ray per receiver and step, Embree, robust, packets of 16
/// consecutive steps. Any surface, any mesh. Cost: receivers x steps / (some 10^7 a second and core).
class RayReference final : public Accumulator {
public:
    explicit RayReference(RayReferenceSettings settings = {});
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const override;

private:
    RayReferenceSettings settings_;
};

}  // namespace noonmark
