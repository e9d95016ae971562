#include "core/measures/outlines/shadow_fan.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/city/footprints/plan_overlay.h"

namespace noonmark {

namespace {

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

Result<ShadowFan> outlineShadowFan(const City& proposal, std::span<const SunStep> steps,
                                   const OutlineSettings& settings, Progress& progress,
                                   const std::stop_token& stop) {
    const City ground{proposal.frame, {}, proposal.terrain};
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

Box2 boundShadows(const City& city, std::span<const SunStep> steps, double longestM) {
    Box2 box;
    for (const auto& building : city.buildings) {
        box.add(bounds(*building));
        const double groundM = lowestGroundUnder(city, bounds(*building));
        for (const SunStep& step : steps) addShadow(*building, groundM, step, longestM, box);
    }
    return box;
}

}  // namespace noonmark
