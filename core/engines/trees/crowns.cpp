#include "core/engines/trees/crowns.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/trees/crowns_around.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

int dayOfYear(CivilDate date) {
    using namespace std::chrono;
    return int((sys_days(date) - sys_days(date.year() / January / 1)).count()) + 1;
}

ShadowField copyOfColumn(const ShadowField& without) {
    ShadowField column = without;
    column.warnings.clear();
    column.cost = {};
    column.trees.reset();
    return column;
}

}  // namespace

bool isInLeaf(const LeafDays& leafDays, CivilDate date) { return leafDays.inLeafOn(dayOfYear(date)); }

namespace {

CrownScene makeScene(const City& city, const std::vector<std::uint32_t>& trees, const SunSteps& sun) {
    CrownScene scene{.trees = trees};
    for (const std::uint32_t tree : trees) scene.crowns.push_back(makeCrown(city.trees->trees[tree]));
    if (scene.empty()) return scene;
    scene.inLeaf.assign(sun.steps.size(), 0);
    for (const SunDay& day : sun.days)
        if (isInLeaf(city.trees->leafDays, day.date))
            std::fill_n(scene.inLeaf.begin() + day.first, day.count, std::uint8_t{1});
    return scene;
}

}  // namespace

CrownScene findCrowns(const City& city, const Receivers& receivers, const SunSteps& sun) {
    return makeScene(city, findTreesInReach(city, receivers, sun), sun);
}

CrownScene findCrowns(const City& city, const SurfacePoints& points, const SunSteps& sun) {
    Box2 box;
    float lowestM = std::numeric_limits<float>::max();
    for (const glm::vec3 place : points.positions) {
        box.add(glm::vec2(place));
        lowestM = std::min(lowestM, place.z);
    }
    return makeScene(city, findTreesInReach(city, box, lowestM, sun), sun);
}

TreeShade makeTreeShade(const ShadowField& without, std::size_t treesUsed) {
    return {.evergreen = copyOfColumn(without), .seasonal = copyOfColumn(without), .treesUsed = treesUsed};
}

namespace {

constexpr std::size_t receiversOfWord = 64;

// The crowns that may shade one of these origins.
std::vector<std::uint32_t> findCrownsNear(const std::vector<Crown>& crowns,
                                          std::span<const glm::vec3> origins, double lowestTan) {
    const glm::dvec3 first(origins.front());
    double widthM = 0, lowestM = first.z;
    for (const glm::vec3 origin : origins) {
        widthM = std::max(widthM, std::hypot(double(origin.x) - first.x, double(origin.y) - first.y));
        lowestM = std::min(lowestM, double(origin.z));
    }
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < crowns.size(); ++i) {
        const double gapM =
            std::hypot(crowns[i].x - first.x, crowns[i].y - first.y) - widthM - crowns[i].radiusM - 1;
        if (gapM <= 0 || crowns[i].topM - lowestM >= lowestTan * gapM) near.push_back(i);
    }
    return near;
}

}  // namespace

CrownMasks::CrownMasks(const City& city, const Box2& receivers, float lowestM, const SunSteps& sun) {
    for (const std::uint32_t tree : findTreesInReach(city, receivers, lowestM, sun))
        crowns_.push_back(makeCrown(city.trees->trees[tree]));
    if (!empty()) leafDays_ = city.trees->leafDays;
}

void CrownMasks::addTo(StepMasks& masks, CivilDate day, std::span<const SunStep> steps,
                       std::span<const glm::vec3> origins) const {
    if (empty() || steps.empty() || origins.empty()) return;
    const SunPatches patches(steps);
    const bool inLeaf = isInLeaf(leafDays_, day);
    // Each word of a step belongs to one task.
    tbb::parallel_for(std::size_t{0}, masks.wordsPerStep(), [&](std::size_t word) {
        const FlushDenormals flush;
        const std::size_t first = word * receiversOfWord,
                          count = std::min(receiversOfWord, origins.size() - first);
        const auto near = findCrownsNear(crowns_, origins.subspan(first, count), patches.lowestTan());
        if (near.empty()) return;
        CrownsOverPoint over(crowns_, patches);
        for (std::size_t receiver = first; receiver < first + count; ++receiver) {
            if (!over.begin(glm::dvec3(origins[receiver]), near)) continue;
            for (std::uint32_t step = 0; step < steps.size(); ++step)
                if (!masks.shaded(step, receiver) &&
                    over.at(patches.ofStep(step)).takenShare(inLeaf) >= TreeShade::defaultShadedFrom)
                    masks.shade(step, receiver);
        }
    });
}

}  // namespace noonmark
