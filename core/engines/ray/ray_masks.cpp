#include "core/engines/ray/ray_masks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/common/shared_buildings.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "core/simd/flush_denormals.h"
#include "core/sun/chosen_days.h"

namespace noonmark {

namespace {

constexpr std::size_t receiversAWord = 64;

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
        const std::size_t first = word * receiversAWord,
                          end = std::min(first + receiversAWord, receivers.cells.size());
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
    const std::size_t words = (receivers.cells.size() + receiversAWord - 1) / receiversAWord;
    tbb::parallel_for(std::size_t{0}, words, [&](std::size_t word) {
        const FlushDenormals flush;
        WordTracer tracer(receivers, word);
        for (std::size_t i = 0; i < packets.size() && !stop.stop_requested(); ++i)
            tracer.trace(scenes, packets[i], i * DirectionPacket::capacity, masks);
    });
    return masks;
}

}  // namespace

Result<void> computeRayMasks(std::span<const City* const> cities, const Receivers& receivers,
                             const SunSteps& sun, const TakeDay& take, Progress& progress,
                             const std::stop_token& stop) {
    progress.report(0, "building the ray scene");
    const auto scenes = buildScenes(cities, receivers, sun, stop);
    if (!scenes) return tl::make_unexpected(scenes.error());
    for (std::size_t day = 0; day < sun.days.size(); ++day) {
        const std::size_t numbers[]{day};
        auto masks = traceDay(*scenes, receivers, chooseDays(sun, numbers), stop);
        if (stop.stop_requested()) return cancelled();
        if (auto taken = take(day, masks); !taken) return taken;
        progress.report(double(day + 1) / double(sun.days.size()), "tracing rays");
    }
    return {};
}

}  // namespace noonmark
