#include "core/measures/shadow_outlines.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/base/memory_guard.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/measures/outlines/moment_outlines.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

Result<void> checkArea(const OutlineSettings& settings) {
    const glm::dvec2 size = glm::dvec2(settings.area.high) - glm::dvec2(settings.area.low);
    if (std::isfinite(size.x) && std::isfinite(size.y) && size.x > 0 && size.y > 0) return {};
    return failure("The area of the outlines is empty", "area", "Choose a box with an interior");
}

Result<std::vector<ShadowOutlines>> outlineOnLevelGround(const City& baseline, const City* scenario,
                                                         std::span<const SunStep> steps, const Box2& area,
                                                         Progress& progress, const std::stop_token& stop) {
    const LevelOutliner outliner(baseline, scenario, area);
    std::vector<ShadowOutlines> all;
    for (const SunStep& step : steps) {
        ProgressShare share(progress, all.size(), steps.size());
        auto outlines = outliner.outline(step, share, stop);
        if (!outlines) return tl::make_unexpected(outlines.error());
        all.push_back(*std::move(outlines));
    }
    return all;
}

/// On a plane: the cities above it are cast on it as on level ground, where they have neither terrain nor
/// meshes. Else cells of the plane are traced.
Result<std::vector<ShadowOutlines>> outlineOnPlane(const City& baseline, const City* scenario,
                                                   std::span<const SunStep> steps,
                                                   const OutlineSettings& settings, Progress& progress,
                                                   const std::stop_token& stop) {
    const auto before = cutAbovePlane(baseline, *settings.planeM);
    const auto after = scenario == nullptr ? std::nullopt : cutAbovePlane(*scenario, *settings.planeM);
    if (!before || (scenario != nullptr && !after))
        return traceOutlines(baseline, scenario, steps, settings, progress, stop);
    return outlineOnLevelGround(*before, after ? &*after : nullptr, steps, settings.area, progress, stop);
}

}  // namespace

Result<std::vector<ShadowOutlines>> outlineShadows(const City& baseline, const City* scenario,
                                                   std::span<const SunStep> steps,
                                                   const OutlineSettings& settings, Progress& progress,
                                                   const std::stop_token& stop) {
    if (auto checked = checkArea(settings); !checked) return tl::make_unexpected(checked.error());
    return guardMemory({.what = "the outlines of these shadows", .advice = "Choose a smaller area"}, [&] {
        if (settings.planeM) return outlineOnPlane(baseline, scenario, steps, settings, progress, stop);
        return baseline.terrain || (scenario != nullptr && scenario->terrain)
                   ? traceOutlines(baseline, scenario, steps, settings, progress, stop)
                   : outlineOnLevelGround(baseline, scenario, steps, settings.area, progress, stop);
    });
}

Result<ShadowOutlines> outlineShadows(const City& baseline, const City* scenario, const SunStep& step,
                                      const OutlineSettings& settings, Progress& progress,
                                      const std::stop_token& stop) {
    return outlineShadows(baseline, scenario, std::span(&step, 1), settings, progress, stop)
        .and_then(
            [](std::vector<ShadowOutlines> all) -> Result<ShadowOutlines> { return std::move(all.front()); });
}

double area(std::span<const Footprint> polygons) {
    return std::accumulate(polygons.begin(), polygons.end(), 0.0,
                           [](double sum, const Footprint& polygon) { return sum + area(polygon); });
}

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
