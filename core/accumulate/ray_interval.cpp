#include "core/accumulate/ray_interval.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "core/accumulate/flush_denormals.h"
#include "core/accumulate/ray_reference.h"
#include "core/accumulate/ray_scene.h"
#include "core/accumulate/reach.h"
#include "core/accumulate/receiver_tiles.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

std::vector<DirectionPacket> packetsOf(const SunInterval& interval) {
    SunSteps sun;
    for (int step = 0; step < interval.steps; ++step)
        sun.steps.push_back({.direction = glm::vec3(interval.at(step)), .slot = step});
    std::vector<DirectionPacket> packets;
    for (const SunPacket& packet : sunPackets(sun)) packets.push_back(packet.directions);
    return packets;
}

class RayIntervalScene final : public IntervalScene {
public:
    RayIntervalScene(RayScene scene, const Receivers& receivers, std::uint32_t buildingsUsed)
        : scene_(std::move(scene)), receivers_(receivers), tiles_(receivers) {
        cost_.buildingsUsed = buildingsUsed;
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        const Stopwatch watch;
        const std::vector<DirectionPacket> packets = packetsOf(interval);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tiles_.count()), [&](const auto& range) {
            const FlushDenormals flush;
            std::vector<std::uint32_t> cells;
            for (std::size_t tile = range.begin(); tile < range.end() && !stop.stop_requested(); ++tile) {
                tiles_.cellsOf(tile, cells);
                trace(cells, packets, masks);
            }
        });
        if (stop.stop_requested()) return cancelled();
        cost_.seconds["trace"] += watch.seconds();
        cost_.rays += receivers_.cells.size() * std::size_t(interval.steps);
        return {};
    }

    Result<void> attribute(const SunInterval& interval, std::span<std::uint64_t> cellSteps,
                           std::stop_token stop) override {
        tbb::combinable<std::vector<std::uint64_t>> sums(
            [&] { return std::vector<std::uint64_t>(cellSteps.size()); });
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tiles_.count()), [&](const auto& range) {
            const FlushDenormals flush;
            std::vector<std::uint32_t> cells;
            for (std::size_t tile = range.begin(); tile < range.end() && !stop.stop_requested(); ++tile) {
                tiles_.cellsOf(tile, cells);
                for (int step = 0; step < interval.steps; ++step)
                    countFirst(cells, glm::vec3(interval.at(step)), sums.local());
            }
        });
        if (stop.stop_requested()) return cancelled();
        sums.combine_each([&](const std::vector<std::uint64_t>& sum) {
            for (std::size_t i = 0; i < sum.size(); ++i) cellSteps[i] += sum[i];
        });
        return {};
    }

    [[nodiscard]] Cost cost() const override { return cost_; }

private:
    void countFirst(const std::vector<std::uint32_t>& cells, glm::vec3 towardsSun,
                    std::vector<std::uint64_t>& cellSteps) const {
        constexpr std::size_t packet = 16;
        std::array<Occluder, packet> found;
        std::vector<glm::vec3> origins;
        for (const std::uint32_t cell : cells) origins.push_back(rayOrigin(receivers_.position(cell)));
        for (std::size_t i = 0; i < origins.size(); i += packet) {
            const std::size_t count = std::min(packet, origins.size() - i);
            scene_.firstOccluders(std::span(origins).subspan(i, count), towardsSun, RayScene::nearestM, 1,
                                  std::span(found).first(count));
            for (std::size_t k = 0; k < count; ++k)
                if (found[k].distanceM > 0) ++cellSteps[found[k].building];
        }
    }

    // The tiles' cells are looked up among all, which are ascending.
    void trace(const std::vector<std::uint32_t>& cells, const std::vector<DirectionPacket>& packets,
               std::span<ShadowMask> masks) const {
        std::vector<glm::vec3> origins;
        for (const std::uint32_t cell : cells) origins.push_back(rayOrigin(receivers_.position(cell)));
        std::vector<ShadowMask> found(cells.size());
        std::vector<std::uint32_t> blocked(cells.size());
        for (std::size_t packet = 0; packet < packets.size(); ++packet) {
            scene_.blockedLanes(origins, packets[packet], blocked);
            for (std::size_t i = 0; i < cells.size(); ++i)
                found[i] |= ShadowMask{blocked[i] & ((1U << unsigned(packets[packet].count)) - 1)}
                            << (packet * DirectionPacket::capacity);
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto at = std::ranges::lower_bound(receivers_.cells, cells[i]);
            masks[std::size_t(at - receivers_.cells.begin())] = found[i];
        }
    }

    RayScene scene_;
    const Receivers& receivers_;
    ReceiverTiles tiles_;
    Cost cost_;
};

}  // namespace

Result<std::unique_ptr<IntervalScene>> RayIntervals::prepare(const City& city, const Receivers& receivers,
                                                             const SunSteps& directions,
                                                             std::stop_token stop) const {
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, directions);
    auto scene = RayScene::over(city, used, std::move(stop));
    if (!scene) return tl::make_unexpected(scene.error());
    return std::make_unique<RayIntervalScene>(std::move(*scene), receivers, std::uint32_t(used.size()));
}

std::string RayIntervals::describe() const {
    return "Rays at each step of a straight sun, " + RayScene::backend();
}

}  // namespace noonmark
