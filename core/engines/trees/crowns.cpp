#include "core/engines/trees/crowns.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/trees/crowns_around.h"
#include "core/simd/flush_denormals.h"
#include "core/sun/civil_time.h"

namespace noonmark {

namespace {

ShadowField copyOfColumn(const ShadowField& without) {
    ShadowField column = without;
    column.warnings.clear();
    column.cost = {};
    column.trees.reset();
    return column;
}

}  // namespace

bool isInLeaf(const LeafDays& leafDays, CivilDate date) { return leafDays.inLeafOn(dayOfCommonYear(date)); }

namespace {

Crown makeCrown(const Tree& tree, LeafSeasons& seasons) {
    Crown crown = noonmark::makeCrown(tree);
    crown.season = seasons.add(tree);
    return crown;
}

}  // namespace

LeafPhases findLeafPhases(const LeafSeasons& seasons, std::span<const int> days) {
    LeafPhases phases;
    if (seasons.isUniform()) return phases;
    std::map<std::string, std::uint16_t> known;  // by a letter for each season
    for (const int day : days) {
        std::vector<std::uint8_t> inLeaf;
        for (const LeafDays& season : seasons.days()) inLeaf.push_back(season.inLeafOn(day) ? 1 : 0);
        const auto [found, isNew] =
            known.try_emplace(std::string(inLeaf.begin(), inLeaf.end()), std::uint16_t(phases.inLeaf.size()));
        if (isNew) phases.inLeaf.push_back(std::move(inLeaf));
        phases.ofStep.push_back(found->second);
    }
    return phases;
}

LeafPhases findLeafPhases(const LeafSeasons& seasons, const SunSteps& sun) {
    if (seasons.isUniform()) return {};
    std::vector<int> days;
    for (const SunDay& day : sun.days) days.push_back(dayOfCommonYear(day.date));
    LeafPhases phases = findLeafPhases(seasons, days);
    std::vector<std::uint16_t> ofStep(sun.steps.size());
    for (std::size_t i = 0; i < sun.days.size(); ++i)
        std::fill_n(ofStep.begin() + sun.days[i].first, sun.days[i].count, phases.ofStep[i]);
    phases.ofStep = std::move(ofStep);
    return phases;
}

namespace {

// A period with one phase needs none: what is bare in it is bare at every step.
void joinSinglePhase(CrownScene& scene) {
    if (scene.phases.empty() || scene.phases.count() > 1) return;
    for (Crown& crown : scene.crowns) crown.leafOffPerM = scene.phases.perM(0, crown);
    scene.phases = {};
}

}  // namespace

CrownScene makeCrownScene(const City& city, std::vector<std::uint32_t> trees, const SunSteps& sun) {
    CrownScene scene{.trees = std::move(trees)};
    if (scene.trees.empty()) return scene;
    LeafSeasons seasons(city.trees->leafDays);
    for (const std::uint32_t tree : scene.trees)
        scene.crowns.push_back(makeCrown(city.trees->trees[tree], seasons));
    scene.inLeaf.assign(sun.steps.size(), 0);
    if (!seasons.isUniform()) {
        scene.phases = findLeafPhases(seasons, sun);
        joinSinglePhase(scene);
        return scene;
    }
    for (const SunDay& day : sun.days)
        if (isInLeaf(city.trees->leafDays, day.date))
            std::fill_n(scene.inLeaf.begin() + day.first, day.count, std::uint8_t{1});
    return scene;
}

CrownScene findCrowns(const City& city, const Receivers& receivers, const SunSteps& sun) {
    return makeCrownScene(city, findTreesInReach(city, receivers, sun), sun);
}

CrownScene findCrowns(const City& city, const SurfacePoints& points, const SunSteps& sun) {
    Box2 box;
    float lowestM = std::numeric_limits<float>::max();
    for (const glm::vec3 place : points.positions) {
        box.add(glm::vec2(place));
        lowestM = std::min(lowestM, place.z);
    }
    return makeCrownScene(city, findTreesInReach(city, box, lowestM, sun), sun);
}

TreeShade makeTreeShade(const ShadowField& without, std::size_t treesUsed) {
    return {.evergreen = copyOfColumn(without), .seasonal = copyOfColumn(without), .treesUsed = treesUsed};
}

std::vector<std::uint32_t> findCrownsNear(const std::vector<Crown>& crowns, std::span<const glm::vec3> places,
                                          double lowestTan) {
    const glm::dvec3 first(places.front());
    double widthM = 0, lowestM = first.z;
    for (const glm::vec3 place : places) {
        widthM = std::max(widthM, std::hypot(double(place.x) - first.x, double(place.y) - first.y));
        lowestM = std::min(lowestM, double(place.z));
    }
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < crowns.size(); ++i) {
        const double gapM =
            std::hypot(crowns[i].x - first.x, crowns[i].y - first.y) - widthM - crowns[i].radiusM - 1;
        if (gapM <= 0 || crowns[i].topM - lowestM >= lowestTan * gapM) near.push_back(i);
    }
    return near;
}

CrownMasks::CrownMasks(const City& city, const Box2& receivers, float lowestM, const SunSteps& sun) {
    const std::vector<std::uint32_t> trees = findTreesInReach(city, receivers, lowestM, sun);
    if (!trees.empty()) seasons_ = LeafSeasons(city.trees->leafDays);
    for (const std::uint32_t tree : trees) crowns_.push_back(makeCrown(city.trees->trees[tree], seasons_));
}

void CrownMasks::addTo(StepMasks& masks, CivilDate day, std::span<const SunStep> steps,
                       std::span<const glm::vec3> origins) const {
    if (empty() || steps.empty() || origins.empty()) return;
    const SunPatches patches(steps);
    const bool inLeaf = isInLeaf(seasons_.days().front(), day);
    const int ofYear[]{dayOfCommonYear(day)};
    LeafPhases phase = findLeafPhases(seasons_, ofYear);
    if (!phase.empty()) phase.ofStep.assign(steps.size(), 0);
    // Each word of a step belongs to one task.
    constexpr std::size_t receiversOfWord = 64;
    tbb::parallel_for(std::size_t{0}, masks.wordsPerStep(), [&](std::size_t word) {
        const FlushDenormals flush;
        const std::size_t first = word * receiversOfWord,
                          count = std::min(receiversOfWord, origins.size() - first);
        const auto near = findCrownsNear(crowns_, origins.subspan(first, count), patches.lowestTan());
        if (near.empty()) return;
        CrownsOverPoint over(crowns_, patches, phase);
        for (std::size_t receiver = first; receiver < first + count; ++receiver) {
            if (!over.begin(glm::dvec3(origins[receiver]), near)) continue;
            for (std::uint32_t step = 0; step < steps.size(); ++step)
                if (!masks.shaded(step, receiver) &&
                    over.at(step).takenShare(inLeaf && phase.empty()) >= TreeShade::defaultShadedFrom)
                    masks.shade(step, receiver);
        }
    });
}

}  // namespace noonmark
