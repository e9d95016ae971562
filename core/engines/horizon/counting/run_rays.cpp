#include "core/engines/horizon/counting/run_rays.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

Result<RunRays> RunRays::over(const City& city, std::span<const std::uint32_t> used,
                              const Receivers& receivers, const SunSteps& sun, bool checksRuns,
                              const std::stop_token& stop) {
    auto scene = RayScene::over(city, used, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    return RunRays(*std::move(scene), findOpenBelow(city, used), receivers, sun, checksRuns);
}

RunRays::Receiver RunRays::of(std::uint32_t cell) const {
    return {*this, placeRayOrigin(receivers_.position(cell))};
}

bool RunRays::Receiver::hidden(std::uint32_t step) const {
    rays_->decided_->rays.fetch_add(1, std::memory_order_relaxed);
    return rays_->scene_.occluded(origin_, rays_->sun_.steps[step].direction);
}

std::uint32_t RunRays::Receiver::findLit(std::span<const std::uint32_t> steps) const {
    DirectionPacket packet{.count = int(steps.size())};
    for (std::size_t lane = 0; lane < together; ++lane) {
        const glm::vec3 direction = rays_->sun_.steps[steps[std::min(lane, steps.size() - 1)]].direction;
        packet.x[lane] = direction.x;
        packet.y[lane] = direction.y;
        packet.z[lane] = direction.z;
    }
    std::uint32_t blocked = 0;
    rays_->scene_.blockedLanes({&origin_, 1}, packet, {&blocked, 1});
    rays_->decided_->rays.fetch_add(steps.size(), std::memory_order_relaxed);
    return ~blocked & std::uint32_t((1ULL << steps.size()) - 1);
}

std::optional<std::uint32_t> RunRays::Receiver::findLit(std::uint32_t first, std::uint32_t end) const {
    std::array<std::uint32_t, together> steps;
    for (; first < end; first += std::uint32_t(together)) {
        std::iota(steps.begin(), steps.end(), first);
        const std::uint32_t lit =
            findLit(std::span(steps).first(std::min<std::size_t>(together, end - first)));
        if (lit != 0) return first + std::uint32_t(std::countr_zero(lit));
    }
    return std::nullopt;
}

RunSearch::Rays RunRays::Receiver::forSearch() const {
    RunSearch::Rays rays;
    rays.hidden = [*this](std::uint32_t step) { return hidden(step); };
    if (rays_->checkRuns())
        rays.findLit = [*this](std::uint32_t first, std::uint32_t end) { return findLit(first, end); };
    return rays;
}

}  // namespace noonmark
