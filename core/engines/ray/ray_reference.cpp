#include "core/engines/ray/ray_reference.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/receiver_tiles.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/tree_rays.h"
#include "core/receivers/receivers.h"
#include "core/simd/flush_denormals.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

namespace {

constexpr std::size_t receiversPerWord = 64;

std::vector<std::uint32_t> inBoth(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return both;
}

/// What the cities share, terrain included, and what each has of its own.
struct CityScenes {
    std::optional<RayScene> common;
    std::vector<std::optional<RayScene>> own;  // none where a city has no building of its own in reach
};

Result<CityScenes> buildScenes(std::span<const City* const> cities, const Receivers& receivers,
                               const SunSteps& sun, const std::stop_token& stop) {
    const SharedBuildings shared = findSharedBuildings(cities);
    CityScenes scenes;
    for (std::size_t i = 0; i < cities.size(); ++i) {
        const auto near = findBuildingsInReach(*cities[i], receivers, sun);
        if (i == 0) {
            auto common = RayScene::over(*cities[0], inBoth(shared.common, near), stop);
            if (!common) return tl::make_unexpected(common.error());
            scenes.common = *std::move(common);
        }
        const auto mine = inBoth(shared.own[i], near);
        scenes.own.emplace_back();
        if (mine.empty()) continue;
        City alone = *cities[i];
        alone.terrain = nullptr;  // it is in the common scene
        auto own = RayScene::over(alone, mine, stop);
        if (!own) return tl::make_unexpected(own.error());
        scenes.own.back() = *std::move(own);
    }
    return scenes;
}

/// Up to 64 receivers, which are one word of the masks.
class WordTracer {
public:
    WordTracer(const Receivers& receivers, std::size_t word) : word_(word) {
        const std::size_t first = word * receiversPerWord,
                          end = std::min(first + receiversPerWord, receivers.cells.size());
        for (std::size_t i = first; i < end; ++i)
            origins_.push_back(placeRayOrigin(receivers.position(receivers.cells[i])));
        common_.resize(origins_.size());
        blocked_.resize(origins_.size());
    }

    void trace(const CityScenes& scenes, const SunPacket& packet, std::size_t firstStep,
               std::vector<StepMasks>& masks) {
        scenes.common->blockedLanes(origins_, packet.directions, common_);
        for (std::size_t city = 0; city < masks.size(); ++city) {
            std::ranges::fill(blocked_, 0U);
            if (scenes.own[city]) scenes.own[city]->blockedLanes(origins_, packet.directions, blocked_);
            write(std::size_t(packet.directions.count), firstStep, masks[city]);
        }
    }

private:
    void write(std::size_t steps, std::size_t firstStep, StepMasks& masks) const {
        for (std::size_t step = 0; step < steps; ++step) {
            std::uint64_t word = 0;
            for (std::size_t i = 0; i < origins_.size(); ++i)
                word |= std::uint64_t((common_[i] | blocked_[i]) >> step & 1U) << i;
            masks.at(firstStep + step)[word_] = word;
        }
    }

    std::size_t word_;
    std::vector<glm::vec3> origins_;
    std::vector<std::uint32_t> common_, blocked_;
};

std::vector<StepMasks> traceDay(const CityScenes& scenes, const Receivers& receivers, const SunSteps& day,
                                const std::stop_token& stop) {
    std::vector<StepMasks> masks(scenes.own.size(), StepMasks(receivers.cells.size(), day.steps.size()));
    const std::vector<SunPacket> packets = packSteps(day);
    const std::size_t words = (receivers.cells.size() + receiversPerWord - 1) / receiversPerWord;
    tbb::parallel_for(std::size_t{0}, words, [&](std::size_t word) {
        const FlushDenormals flush;
        WordTracer tracer(receivers, word);
        for (std::size_t i = 0; i < packets.size() && !stop.stop_requested(); ++i)
            tracer.trace(scenes, packets[i], i * DirectionPacket::capacity, masks);
    });
    return masks;
}

/// Engine::shadeSteps() with one ray for each receiver and step, on any ground. Buildings that all cities
/// share are traced once; each city's others in a scene of their own. Some 10^7 rays a second and core.
Result<void> computeRayMasks(std::span<const City* const> cities, const Receivers& receivers,
                             const SunSteps& sun, const TakeDay& take, Progress& progress,
                             const std::stop_token& stop) {
    progress.report(0, NM_TEXT("building the ray scene"));
    const auto scenes = buildScenes(cities, receivers, sun, stop);
    if (!scenes) return tl::make_unexpected(scenes.error());
    for (std::size_t day = 0; day < sun.days.size(); ++day) {
        const std::size_t numbers[]{day};
        auto masks = traceDay(*scenes, receivers, chooseDays(sun, numbers), stop);
        if (stop.stop_requested()) return cancelled();
        if (auto taken = take(day, masks); !taken) return taken;
        progress.report(double(day + 1) / double(sun.days.size()), NM_TEXT("tracing rays"));
    }
    return {};
}

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
            progress_.report(double(now) / double(all), NM_TEXT("tracing rays"));
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
    progress.report(0, NM_TEXT("building the ray scene"));
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
    progress.report(1, NM_TEXT("tracing rays"));
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
