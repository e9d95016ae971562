#include "core/engines/points/horizons/point_run_rays.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/engines/ray/surface_rays.h"

namespace noonmark {

PointRunRays::PointRunRays(const RayScene& scene, const SunSteps& sun, glm::vec3 position, glm::vec3 normal)
    : scene_(scene), sun_(sun), origin_(placeSurfaceRayOrigin(position, normal)), normal_(normal) {}

std::uint32_t PointRunRays::findShaded(std::span<const std::uint32_t> steps) const {
    if (steps.size() == 1) return isShaded(sun_.steps[steps[0]].direction) ? 1 : 0;
    DirectionPacket packet{.count = int(steps.size())};
    std::uint32_t away = 0;
    for (std::size_t lane = 0; lane < together; ++lane) {
        const glm::vec3 sun = sun_.steps[steps[std::min(lane, steps.size() - 1)]].direction;
        packet.x[lane] = sun.x;
        packet.y[lane] = sun.y;
        packet.z[lane] = sun.z;
        if (normal_.x * sun.x + normal_.y * sun.y + normal_.z * sun.z <= 0) away |= 1U << lane;
    }
    std::uint32_t blocked = 0;
    scene_.blockedLanes({&origin_, 1}, packet, {&blocked, 1});
    rays_ += steps.size();
    return (blocked | away) & std::uint32_t((1ULL << steps.size()) - 1);
}

bool PointRunRays::isShaded(glm::vec3 sun) const {
    if (normal_.x * sun.x + normal_.y * sun.y + normal_.z * sun.z <= 0) return true;
    ++rays_;
    return scene_.occluded(origin_, sun);
}

}  // namespace noonmark
