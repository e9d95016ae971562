#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/describe/text.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/tree_rays.h"
#include "core/engines/trees/crowns_around.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

constexpr double maxRaysOfTrees = 1e8;

/// Steps of one patch of the sun.
struct PatchSteps {
    double inLeaf = 0, bare = 0;  // minutes, with the leaves on and off
    std::size_t phase = 0;
};

/// What crowns take from one receiver, minutes by crown; only of those that take some.
struct CrownTaken {
    std::uint32_t crown;
    double evergreen = 0, evergreenSole = 0, seasonal = 0, seasonalSole = 0;
};

/// Measures one receiver after the other. Reuses its memory; for one thread.
class TakenFromReceiver {
public:
    /// `scene`: null where the steps of the patches leave out what is shaded.
    TakenFromReceiver(const RayScene* scene, const CrownScene& crowns, const SunPatches& patches,
                      const std::vector<PatchSteps>& steps)
        : scene_(scene), crowns_(crowns), patches_(patches), steps_(steps), all_(crowns.crowns.size()) {
        std::iota(all_.begin(), all_.end(), 0U);
        sums_.resize(all_.size());
    }

    std::vector<CrownTaken> measure(glm::vec3 origin) {
        std::vector<CrownTaken> taken;
        if (!around_.gather(crowns_.crowns, all_, glm::dvec3(origin), patches_.lowestTan())) return taken;
        touched_.clear();
        for (std::uint32_t patch = 0; patch < patches_.count(); ++patch) addPatch(origin, patch);
        for (const std::uint32_t crown : touched_) {
            taken.push_back(sums_[crown]);
            sums_[crown] = {};
        }
        return taken;
    }

private:
    struct OnRay {
        std::uint32_t crown;
        double inLeaf, bare;  // optical depths
    };

    void addPatch(glm::vec3 origin, std::uint32_t patch) {
        onRay_.clear();
        double inLeaf = 0, bare = 0;
        const PatchSteps& steps = steps_[patch];
        for (const std::uint32_t index : around_.at(patches_.slot(patch))) {
            const Crown& crown = crowns_.crowns[index];
            const double chord = computeChord(crown, glm::dvec3(origin), patches_.direction(patch));
            if (chord <= 0) continue;
            onRay_.push_back(
                {index, chord * crown.leafOnPerM, chord * crowns_.phases.perM(steps.phase, crown)});
            inLeaf += onRay_.back().inLeaf;
            bare += onRay_.back().bare;
        }
        if (onRay_.empty() || isHidden(origin, patch)) return;
        for (const OnRay& one : onRay_) {
            CrownTaken& sum = sumOf(one.crown);
            const double shareOn = shareOf(one.inLeaf, inLeaf), shareOff = shareOf(one.bare, bare);
            const double soleOn = soleOf(one.inLeaf, inLeaf), soleOff = soleOf(one.bare, bare);
            sum.evergreen += (steps.inLeaf + steps.bare) * shareOn;
            sum.evergreenSole += (steps.inLeaf + steps.bare) * soleOn;
            sum.seasonal += steps.inLeaf * shareOn + steps.bare * shareOff;
            sum.seasonalSole += steps.inLeaf * soleOn + steps.bare * soleOff;
        }
    }

    [[nodiscard]] bool isHidden(glm::vec3 origin, std::uint32_t patch) const {
        return scene_ != nullptr && scene_->occluded(origin, glm::vec3(patches_.direction(patch)));
    }

    // Of the share of the sun that all crowns take.
    static double shareOf(double depth, double all) { return all > 0 ? -std::expm1(-all) * depth / all : 0; }
    static double soleOf(double depth, double all) { return std::exp(-all) * std::expm1(depth); }

    CrownTaken& sumOf(std::uint32_t crown) {
        CrownTaken& sum = sums_[crown];
        if (sum.evergreen == 0) touched_.push_back(crown);
        sum.crown = crown;
        return sum;
    }

    const RayScene* scene_;
    const CrownScene& crowns_;
    const SunPatches& patches_;
    const std::vector<PatchSteps>& steps_;
    std::vector<std::uint32_t> all_, touched_;
    std::vector<CrownTaken> sums_;  // by crown
    std::vector<OnRay> onRay_;
    CrownsAround around_;
};

std::vector<PatchSteps> countPatchSteps(const SunPatches& patches, const CrownScene& crowns,
                                        const SunSteps& sun, const std::vector<std::uint8_t>& shaded = {}) {
    std::vector<PatchSteps> all(patches.count());
    for (std::size_t step = 0; step < sun.steps.size(); ++step) {
        PatchSteps& patch = all[patches.ofStep(step)];
        patch.phase = crowns.phases.at(step);
        if (!shaded.empty() && shaded[step] != 0) continue;
        (crowns.inLeaf[step] != 0 ? patch.inLeaf : patch.bare) += sun.stepMinutes;
    }
    return all;
}

// Places in Receivers::cells.
std::vector<std::size_t> spreadCells(std::size_t cells, std::size_t patches) {
    const auto maximum = std::size_t(maxRaysOfTrees / double(std::max<std::size_t>(patches, 1)));
    std::vector<std::size_t> chosen(std::clamp<std::size_t>(maximum, 1, cells));
    for (std::size_t i = 0; i < chosen.size(); ++i)
        chosen[i] = std::size_t((double(i) + 0.5) * double(cells) / double(chosen.size()));
    return chosen;
}

/// The sums of all receivers, added in the order of the cells.
class TakenSums {
public:
    explicit TakenSums(std::size_t crowns) : sums_(crowns) {}

    void add(const std::vector<CrownTaken>& taken, double areaM2) {
        for (const CrownTaken& one : taken) {
            CrownTaken& sum = sums_[one.crown];
            sum.evergreen += one.evergreen * areaM2;
            sum.evergreenSole += one.evergreenSole * areaM2;
            sum.seasonal += one.seasonal * areaM2;
            sum.seasonalSole += one.seasonalSole * areaM2;
        }
    }

    [[nodiscard]] TakenByTree finish(const CrownScene& crowns, std::size_t cells) const {
        TakenByTree taken{.cells = cells};
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            const CrownTaken& sum = sums_[i];
            if (sum.evergreen <= 0) continue;
            taken.evergreen.push_back({crowns.trees[i], sum.evergreen, sum.evergreenSole});
            taken.seasonal.push_back({crowns.trees[i], sum.seasonal, sum.seasonalSole});
        }
        return taken;
    }

private:
    std::vector<CrownTaken> sums_;
};

}  // namespace

Result<TakenByTree> traceTakenByTree(const City& city, const Receivers& receivers, const SunSteps& sun,
                                     Progress& progress, const std::stop_token& stop) {
    const CrownScene crowns = findCrowns(city, receivers, sun);
    if (crowns.empty()) return TakenByTree{};
    const auto scene = RayScene::over(city, findBuildingsInReach(city, receivers, sun), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const SunPatches patches(sun.steps, SunPatches::sunDeg, crowns.phases.ofStep);
    const std::vector<PatchSteps> steps = countPatchSteps(patches, crowns, sun);
    const std::vector<std::size_t> chosen = spreadCells(receivers.cells.size(), patches.count());
    const double cellM2 =
        receivers.grid.cellAreaM2() * double(receivers.cells.size()) / double(chosen.size());
    TakenSums sums(crowns.crowns.size());
    constexpr std::size_t batch = 1024;
    for (std::size_t first = 0; first < chosen.size() && !stop.stop_requested(); first += batch) {
        const std::size_t count = std::min(batch, chosen.size() - first);
        std::vector<std::vector<CrownTaken>> taken(count);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 16), [&](const auto& range) {
            const FlushDenormals flush;
            TakenFromReceiver one(&*scene, crowns, patches, steps);
            for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
                taken[i] =
                    one.measure(placeRayOrigin(receivers.position(receivers.cells[chosen[first + i]])));
        });
        for (std::size_t i = 0; i < count; ++i)
            sums.add(taken[i], cellM2 * (receivers.shares.empty() ? 1 : receivers.shares[chosen[first + i]]));
        progress.report(double(first + count) / double(chosen.size()),
                        NM_TEXT("tracing rays through single trees"));
    }
    if (stop.stop_requested()) return cancelled();
    return sums.finish(crowns, chosen.size());
}

TakenByTree takeFromPoint(const CrownScene& crowns, glm::vec3 origin, const SunSteps& sun,
                          const std::vector<std::uint8_t>& shaded) {
    if (crowns.empty()) return {};
    const SunPatches patches(sun.steps, SunPatches::sunDeg, crowns.phases.ofStep);
    const std::vector<PatchSteps> steps = countPatchSteps(patches, crowns, sun, shaded);
    TakenSums sums(crowns.crowns.size());
    sums.add(TakenFromReceiver(nullptr, crowns, patches, steps).measure(origin), 1);
    return sums.finish(crowns, 1);
}

}  // namespace noonmark
