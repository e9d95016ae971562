#include "core/engines/trees/crowns.h"

#include <algorithm>
#include <chrono>

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

CrownScene findCrowns(const City& city, const Receivers& receivers, const SunSteps& sun) {
    CrownScene scene;
    for (const std::uint32_t tree : findTreesInReach(city, receivers, sun))
        scene.crowns.push_back(makeCrown(city.trees->trees[tree]));
    if (scene.empty()) return scene;
    scene.inLeaf.assign(sun.steps.size(), 0);
    for (const SunDay& day : sun.days)
        if (city.trees->leafDays.inLeafOn(dayOfYear(day.date)))
            std::fill_n(scene.inLeaf.begin() + day.first, day.count, std::uint8_t{1});
    return scene;
}

TreeShade makeTreeShade(const ShadowField& without, std::size_t treesUsed) {
    return {.evergreen = copyOfColumn(without), .seasonal = copyOfColumn(without), .treesUsed = treesUsed};
}

}  // namespace noonmark
