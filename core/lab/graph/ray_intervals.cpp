#include "core/lab/graph/ray_intervals.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "core/base/progress.h"
#include "core/engines/common/receiver_tiles.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

std::vector<DirectionPacket> packetsOf(const SunInterval& interval) {
    SunSteps sun;
    for (int step = 0; step < interval.steps; ++step)
        sun.steps.push_back({.direction = glm::vec3(interval.at(step)), .slot = step});
    std::vector<DirectionPacket> packets;
    for (const SunPacket& packet : packSteps(sun)) packets.push_back(packet.directions);
    return packets;
}

/// The receivers grouped by tile, each with the origin of its rays.
struct TiledReceivers {
    std::vector<glm::vec3> origins;
    std::vector<std::uint32_t> numbers;  ///< index in Receivers::cells
    std::vector<std::size_t> first{0};   ///< first receiver of each tile, and the end

    explicit TiledReceivers(const Receivers& receivers) {
        const ReceiverTiles tiles(receivers);
        std::vector<std::uint32_t> cells;
        for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
            tiles.cellsOf(tile, cells);
            for (const std::uint32_t cell : cells) add(receivers, cell);
            first.push_back(origins.size());
        }
    }

    [[nodiscard]] std::size_t tiles() const { return first.size() - 1; }
    [[nodiscard]] std::span<const glm::vec3> originsOf(std::size_t tile) const {
        return std::span(origins).subspan(first[tile], first[tile + 1] - first[tile]);
    }

private:
    // Receivers::cells is in ascending order.
    void add(const Receivers& receivers, std::uint32_t cell) {
        origins.push_back(placeRayOrigin(receivers.position(cell)));
        const auto at = std::ranges::lower_bound(receivers.cells, cell);
        numbers.push_back(std::uint32_t(at - receivers.cells.begin()));
    }
};

class RayIntervalScene final : public IntervalScene {
public:
    RayIntervalScene(RayScene scene, const Receivers& receivers, std::uint32_t buildingsUsed)
        : scene_(std::move(scene)), receivers_(receivers) {
        cost_.buildingsUsed = buildingsUsed;
    }

    Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                       std::stop_token stop) override {
        return shadeWatched(interval, masks, std::move(stop), {[] { return false; }, {}});
    }

    Result<void> shadeWatched(const SunInterval& interval, std::span<ShadowMask> masks, std::stop_token stop,
                              const MaskWatcher& watcher) override {
        const Stopwatch watch;
        std::ranges::fill(masks, ShadowMask{0});
        int steps = 0;
        for (const DirectionPacket& packet : packetsOf(interval)) {
            trace(packet, steps, masks, stop);
            if (stop.stop_requested()) return cancelled();
            steps += packet.count;
            if (steps < interval.steps && watcher.wants()) watcher.show(steps);
        }
        cost_.seconds["trace"] += watch.seconds();
        cost_.rays += masks.size() * std::size_t(interval.steps);
        return {};
    }

    [[nodiscard]] Cost cost() const override { return cost_; }

private:
    // Traces the same sixteen directions for one receiver after the other, since these rays traverse the same
    // boxes.
    void trace(const DirectionPacket& packet, int firstStep, std::span<ShadowMask> masks,
               const std::stop_token& stop) const {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, receivers_.tiles()), [&](const auto& range) {
            const FlushDenormals flush;
            std::vector<std::uint32_t> blocked;
            for (std::size_t tile = range.begin(); tile < range.end() && !stop.stop_requested(); ++tile) {
                const auto origins = receivers_.originsOf(tile);
                blocked.resize(origins.size());
                scene_.blockedLanes(origins, packet, blocked);
                for (std::size_t i = 0; i < origins.size(); ++i)
                    masks[receivers_.numbers[receivers_.first[tile] + i]] |=
                        (ShadowMask{blocked[i]} & fullMask(packet.count)) << firstStep;
            }
        });
    }

    RayScene scene_;
    TiledReceivers receivers_;
    Cost cost_;
};

}  // namespace

Result<std::unique_ptr<IntervalScene>> RayIntervals::prepare(const City& city, const Receivers& receivers,
                                                             const SunSteps& directions,
                                                             std::stop_token stop) const {
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, directions);
    auto scene = RayScene::over(city, used, std::move(stop));
    if (!scene) return tl::make_unexpected(scene.error());
    return std::make_unique<RayIntervalScene>(std::move(*scene), receivers, std::uint32_t(used.size()));
}

std::string RayIntervals::describe() const {
    return "Rays at each step of a straight sun, " + RayScene::backend();
}

}  // namespace noonmark
