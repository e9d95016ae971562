#include "core/engines/trees/crowns.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/engines/common/shadow_reach.h"

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

namespace {

CrownScene makeScene(const City& city, const std::vector<std::uint32_t>& trees, const SunSteps& sun) {
    CrownScene scene{.trees = trees};
    for (const std::uint32_t tree : trees) scene.crowns.push_back(makeCrown(city.trees->trees[tree]));
    if (scene.empty()) return scene;
    scene.inLeaf.assign(sun.steps.size(), 0);
    for (const SunDay& day : sun.days)
        if (city.trees->leafDays.inLeafOn(dayOfYear(day.date)))
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

}  // namespace noonmark
