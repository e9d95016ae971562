#include "core/lab/bench/contests/ray_masks.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/engines/ray/ray_reference.h"
#include "core/simd/flush_denormals.h"

namespace noonmark::bench {

namespace {

std::vector<DirectionPacket> packetsOf(std::span<const glm::dvec3> directions) {
    SunSteps steps;
    for (const glm::dvec3& direction : directions) steps.steps.push_back({.direction = glm::vec3(direction)});
    steps.days.push_back({.count = std::uint32_t(directions.size())});
    std::vector<DirectionPacket> packets;
    for (const SunPacket& packet : packSteps(steps)) packets.push_back(packet.directions);
    return packets;
}

}  // namespace

RayMasks::RayMasks(RayScene scene, const Receivers& receivers) : scene_(std::move(scene)) {
    for (const std::uint32_t cell : receivers.cells)
        origins_.push_back(placeRayOrigin(receivers.position(cell)));
}

Result<RayMasks> RayMasks::over(const City& city, const Receivers& receivers, const std::stop_token& stop) {
    return RayScene::over(city, stop).map([&](RayScene&& scene) {
        return RayMasks(std::move(scene), receivers);
    });
}

std::vector<ShadowMask> RayMasks::of(std::span<const glm::dvec3> directions) const {
    const std::vector<DirectionPacket> packets = packetsOf(directions);
    std::vector<ShadowMask> masks(origins_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, origins_.size(), 64), [&](const auto& range) {
        const FlushDenormals flush;
        const std::span<const glm::vec3> origins(&origins_[range.begin()], range.size());
        std::vector<std::uint32_t> blocked(range.size());
        for (std::size_t packet = 0; packet < packets.size(); ++packet) {
            scene_.blockedLanes(origins, packets[packet], blocked);
            for (std::size_t i = 0; i < blocked.size(); ++i)
                masks[range.begin() + i] |= ShadowMask{blocked[i] & ((1U << packets[packet].count) - 1U)}
                                            << (packet * DirectionPacket::capacity);
        }
    });
    return masks;
}

}  // namespace noonmark::bench
