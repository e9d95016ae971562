#include "core/measures/outlines/shadow_fan.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/city/footprints/plan_overlay.h"
#include "core/engines/common/shared_buildings.h"

namespace noonmark {

namespace {

SharedBuildings findChanges(const City& baseline, const City& scenario) {
    const std::array<const City*, 2> cities{&baseline, &scenario};
    return findSharedBuildings(cities);
}

City cityOfChanges(const City& baseline, const City& scenario) {
    City proposal = scenario;
    proposal.buildings.clear();
    const SharedBuildings changes = findChanges(baseline, scenario);
    for (const std::uint32_t i : changes.own.back())
        proposal.buildings.push_back(scenario.buildings[i]);
    return proposal;
}

double lowestGroundUnder(const City& city, const Box2& box) {
    if (!city.terrain) return 0;
    const auto& heights = city.terrain->elevationM;
    const double lowest = heights.empty() ? 0 : double(*std::ranges::min_element(heights));
    return std::min(lowest, double(groundAt(city, glm::dvec2(box.low))));
}

void addShadow(const Building& building, double groundM, const SunStep& step, double longestM, Box2& box) {
    const Box2 base = bounds(building);
    const glm::dvec3 sun(step.direction);
    glm::dvec2 shadow = glm::dvec2(sun) / -sun.z * std::max(0.0, double(topM(building)) - groundM);
    if (glm::length(shadow) > longestM) shadow *= longestM / glm::length(shadow);
    box.add(base);
    box.add(Box2{base.low + glm::vec2(shadow), base.high + glm::vec2(shadow)});
}

}  // namespace

Result<ShadowFan> outlineShadowFan(const City& baseline, const City& scenario, std::span<const SunStep> steps,
                                   const OutlineSettings& settings, Progress& progress,
                                   const std::stop_token& stop) {
    City ground = baseline;
    ground.buildings.clear();
    const City proposal = cityOfChanges(baseline, scenario);
    auto outlines = outlineShadows(ground, &proposal, steps, settings, progress, stop);
    if (!outlines) return tl::make_unexpected(outlines.error());
    ShadowFan fan;
    std::vector<Footprint> all;
    for (ShadowOutlines& step : *outlines) {
        fan.cellM = step.cellM;
        all.insert(all.end(), step.incremental.begin(), step.incremental.end());
        fan.ofStep.push_back(std::move(step.incremental));
    }
    fan.all = unitePolygons(all);
    return fan;
}

Box2 boundChangedShadows(const City& baseline, const City& scenario, std::span<const SunStep> steps,
                         double longestM) {
    const SharedBuildings changes = findChanges(baseline, scenario);
    Box2 box;
    const auto add = [&](const City& city, const std::vector<std::uint32_t>& own) {
        for (const std::uint32_t i : own) {
            const Building& building = *city.buildings[i];
            box.add(bounds(building));
            const double groundM = lowestGroundUnder(city, bounds(building));
            for (const SunStep& step : steps) addShadow(building, groundM, step, longestM, box);
        }
    };
    add(baseline, changes.own.front());
    add(scenario, changes.own.back());
    return box;
}

}  // namespace noonmark
