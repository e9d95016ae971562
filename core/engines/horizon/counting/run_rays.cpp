#include "core/engines/horizon/counting/run_rays.h"

#include <bit>

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

namespace {

constexpr std::uint32_t packetSteps = DirectionPacket::capacity;

std::uint32_t bitsFrom(std::uint32_t bit) { return bit >= packetSteps ? 0 : ~std::uint32_t{0} << bit; }

}  // namespace

Result<RunRays> RunRays::over(const City& city, std::span<const std::uint32_t> used,
                              const Receivers& receivers, const SunSteps& sun, bool checksRuns,
                              const std::stop_token& stop) {
    auto scene = RayScene::over(city, used, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    return RunRays(*std::move(scene), receivers, sun, checksRuns);
}

RunRays::RunRays(RayScene scene, const Receivers& receivers, const SunSteps& sun, bool checksRuns)
    : scene_(std::move(scene)), receivers_(receivers), sun_(sun) {
    if (checksRuns) packets_ = packSteps(sun);
}

RunSearch::Rays RunRays::of(std::uint32_t cell) {
    const glm::vec3 origin = placeRayOrigin(receivers_.position(cell));
    RunSearch::Rays rays;
    rays.hidden = [this, origin](std::uint32_t step) { return hidden(origin, step); };
    if (!packets_.empty())
        rays.findLit = [this, origin](std::uint32_t first, std::uint32_t end) {
            return findLit(origin, first, end);
        };
    return rays;
}

bool RunRays::hidden(glm::vec3 origin, std::uint32_t step) const {
    decided_->rays.fetch_add(1, std::memory_order_relaxed);
    return scene_.occluded(origin, sun_.steps[step].direction);
}

std::optional<std::uint32_t> RunRays::findLit(glm::vec3 origin, std::uint32_t first,
                                              std::uint32_t end) const {
    if (first >= end) return std::nullopt;
    decided_->rays.fetch_add(end - first, std::memory_order_relaxed);
    for (std::uint32_t packet = first / packetSteps; packet <= (end - 1) / packetSteps; ++packet) {
        const std::uint32_t from = packet * packetSteps;
        std::uint32_t blocked = 0;
        scene_.blockedLanes({&origin, 1}, packets_[packet].directions, {&blocked, 1});
        const std::uint32_t wanted = bitsFrom(first > from ? first - from : 0) &
                                     ~bitsFrom(std::min(end - from, packetSteps)) & 0xFFFFU;
        if (const std::uint32_t lit = ~blocked & wanted; lit != 0)
            return from + std::uint32_t(std::countr_zero(lit));
    }
    return std::nullopt;
}

}  // namespace noonmark
