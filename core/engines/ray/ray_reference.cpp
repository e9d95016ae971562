#include "core/engines/ray/ray_reference.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/stopwatch.h"
#include "core/engines/api/blank_field.h"
#include "core/engines/api/partial_field.h"
#include "core/engines/common/finished_tiles.h"
#include "core/engines/common/receiver_tiles.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_masks.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/tree_rays.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

/// The receivers of one tile and their counts so far.
struct Watchers {
    std::vector<std::uint32_t> cells;
    std::vector<glm::vec3> origins;
    std::vector<std::uint32_t> blocked;  ///< result of the current packet
    std::vector<RunCounter> runs;
};

/// Traces all receivers of a study, a tile at a time, on all threads of the arena it is called in.
class Tracer {
public:
    Tracer(const RayScene& scene, const Receivers& receivers, const std::vector<SunPacket>& packets,
           ShadowField& field, Progress& progress, const std::stop_token& stop)
        : scene_(scene),
          receivers_(receivers),
          packets_(packets),
          field_(field),
          progress_(progress),
          stop_(stop),
          tiles_(receivers, sideFor(packets.size(), findPartialSink(progress) != nullptr)),
          finished_(tiles_, field, findPartialSink(progress)) {}

    void run() {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tiles_.count()), [&](const auto& range) {
            const FlushDenormals flush;
            Watchers watchers;
            for (std::size_t turn = range.begin(); turn < range.end() && !stop_.stop_requested(); ++turn)
                traceTile(finished_.tileAt(turn), watchers);
        });
    }

private:
    static constexpr std::size_t packetsBetweenChecks = 16;  // x 64 receivers x 16 rays: under a millisecond

    // With a watcher, long periods use smaller tiles: a full-sized tile takes a fifth of a second, too long
    // between running results.
    static int sideFor(std::size_t packets, bool watched) {
        constexpr std::size_t manyPackets = 2000;
        return watched && packets > manyPackets ? ReceiverTiles::defaultSide / 2 : ReceiverTiles::defaultSide;
    }

    void traceTile(std::size_t tile, Watchers& watchers) {
        tiles_.cellsOf(tile, watchers.cells);
        watchers.origins.clear();
        for (const std::uint32_t cell : watchers.cells)
            watchers.origins.push_back(placeRayOrigin(receivers_.position(cell)));
        watchers.blocked.resize(watchers.cells.size());
        watchers.runs.assign(watchers.cells.size(), {});
        trace(watchers);
        if (stop_.stop_requested()) return;
        for (std::size_t i = 0; i < watchers.cells.size(); ++i) write(watchers.cells[i], watchers.runs[i]);
        finished_.finish(tile);
        report(watchers.cells.size());
    }

    // Traces the same sixteen directions for one receiver after the other, since these rays traverse the same
    // boxes.
    void trace(Watchers& watchers) const {
        for (std::size_t i = 0; i < packets_.size(); ++i) {
            const SunPacket& packet = packets_[i];
            if (i % packetsBetweenChecks == 0 && stop_.stop_requested()) return;
            scene_.blockedLanes(watchers.origins, packet.directions, watchers.blocked);
            for (std::size_t k = 0; k < watchers.runs.size(); ++k)
                watchers.runs[k].add(watchers.blocked[k], packet.starts, packet.directions.count);
        }
    }

    void write(std::uint32_t cell, const RunCounter& runs) const {
        field_.grossMin[cell] = float(runs.total() * field_.stepMinutes / field_.days);
        field_.continuousMin[cell] = float(runs.longest() * field_.stepMinutes);
    }

    void report(std::size_t cells) {
        if (cells == 0) return;
        const std::size_t all = receivers_.cells.size();
        const std::size_t now = done_.fetch_add(cells) + cells;
        if (now * 200 / all != (now - cells) * 200 / all)
            progress_.report(double(now) / double(all), "tracing rays");
    }

    const RayScene& scene_;
    const Receivers& receivers_;
    const std::vector<SunPacket>& packets_;
    ShadowField& field_;
    Progress& progress_;
    const std::stop_token& stop_;
    ReceiverTiles tiles_;
    FinishedTiles finished_;
    std::atomic<std::size_t> done_{0};
};

Result<RayScene> buildScene(const City& city, const Receivers& receivers, const SunSteps& sun, Cost& cost,
                            const std::stop_token& stop) {
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, sun, cost);
    if (stop.stop_requested()) return cancelled();
    auto scene = RayScene::over(city, used, stop);
    cost.seconds["build"] = watch.seconds();
    return scene;
}

Result<ShadowField> traceRays(const City& city, const Receivers& receivers, const SunSteps& sun, int threads,
                              Progress& progress, const std::stop_token& stop) {
    ShadowField field = makeBlankField(receivers, sun);
    field.engine = fmt::format("Ray reference, {}, robust, packets of {}", RayScene::backend(),
                               DirectionPacket::capacity);
    if (stop.stop_requested()) return cancelled();
    progress.report(0, "building the ray scene");
    const auto scene = buildScene(city, receivers, sun, field.cost, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const Stopwatch watch;
    const std::vector<SunPacket> packets = packSteps(sun);
    const int cores = tbb::info::default_concurrency();
    tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
    arena.execute([&] { Tracer(*scene, receivers, packets, field, progress, stop).run(); });
    if (stop.stop_requested()) return cancelled();
    field.cost.seconds["trace"] = watch.seconds();
    if (const CrownScene crowns = findCrowns(city, receivers, sun); !crowns.empty()) {
        auto shade = traceCrowns(*scene, crowns, receivers, sun, field, progress, stop);
        if (!shade) return tl::make_unexpected(shade.error());
        field.trees = std::make_shared<const TreeShade>(*std::move(shade));
    }
    field.cost.rays = std::uint64_t(receivers.cells.size()) * sun.steps.size();
    progress.report(1, "tracing rays");
    return field;
}

}  // namespace

glm::vec3 placeRayOrigin(glm::vec3 receiver) {
    // The spacing of float32 values exceeds half a millimetre 8 km from the origin; the lift grows with it
    // from there.
    const float farthest = std::max(std::abs(receiver.x), std::abs(receiver.y));
    const float lift = RayReferenceSettings::liftM * std::max(1.0F, farthest / 8192.0F);
    return {receiver.x, receiver.y, receiver.z + lift};
}

RayReference::RayReference(RayReferenceSettings settings) : settings_(settings) {}

Result<ShadowField> RayReference::compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                          Progress& progress, std::stop_token stop) const {
    return traceRays(city, receivers, sun, settings_.threads, progress, stop);
}

Result<void> RayReference::computeStepMasks(std::span<const City* const> cities, const Receivers& receivers,
                                            const SunSteps& sun, const TakeDay& take, Progress& progress,
                                            std::stop_token stop) const {
    const int cores = tbb::info::default_concurrency();
    tbb::task_arena arena(settings_.threads > 0 ? std::min(settings_.threads, cores) : cores);
    return arena.execute([&] { return computeRayMasks(cities, receivers, sun, take, progress, stop); });
}

}  // namespace noonmark
