#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/engines/ray/ray_scene.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The rays of one point on a surface, for the steps that its longest runs depend on. Scene and sun must
/// outlive it.
class PointRunRays {
public:
    /// Number of steps that are traced at once.
    static constexpr std::size_t together = std::size_t(DirectionPacket::capacity);

    PointRunRays(const RayScene& scene, const SunSteps& sun, glm::vec3 position, glm::vec3 normal);

    /// Bit k: the point is in shadow at steps[k], or turned away from its sun. At most `together` steps.
    [[nodiscard]] std::uint32_t findShaded(std::span<const std::uint32_t> steps) const;

    [[nodiscard]] std::uint64_t rays() const { return rays_; }

private:
    [[nodiscard]] bool isShaded(glm::vec3 sun) const;

    const RayScene& scene_;
    const SunSteps& sun_;
    glm::vec3 origin_, normal_;
    mutable std::uint64_t rays_ = 0;
};

}  // namespace noonmark
