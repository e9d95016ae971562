#include "core/engines/points/shaded_step_finder.h"

#include <glm/geometric.hpp>

#include "core/engines/ray/surface_rays.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

Result<ShadedStepFinder> ShadedStepFinder::over(const City& city, const SunSteps& sun, By by,
                                                const std::stop_token& stop) {
    auto rays = RayScene::over(city, stop);
    if (!rays) return tl::make_unexpected(rays.error());
    ShadedStepFinder finder(*std::move(rays), sun);
    if (by == By::horizons) finder.horizons_ = std::make_shared<const HorizonScene>(city, sun, true);
    return finder;
}

ShadedSteps ShadedStepFinder::find(const SkyPoint& point) const {
    if (!horizons_) return traceShadedSteps(rays_, point, *sun_);
    const FlushDenormals flush;
    HorizonOfPoint horizon(*horizons_);
    horizon.sweep(point.position, point.normal);
    ShadedSteps shaded;
    horizon.findShadedSteps(shaded);
    const glm::vec3 origin = placeSurfaceRayOrigin(point.position, point.normal);
    for (const SunDay& day : sun_->days) correctDay(day, origin, point.normal, shaded);
    return shaded;
}

// Walks from each change outward, first back, then forth, while rays contradict the horizon.
void ShadedStepFinder::correctDay(const SunDay& day, glm::vec3 origin, glm::vec3 normal,
                                  ShadedSteps& shaded) const {
    const std::uint32_t end = day.first + day.count;
    const auto isCorrected = [&](std::uint32_t step) {
        const glm::vec3 direction = sun_->steps[step].direction;
        const bool hidden = glm::dot(direction, normal) <= 0 || rays_.occluded(origin, direction);
        const bool wrong = hidden != (shaded[step] != 0);
        if (wrong) shaded[step] = hidden ? 1 : 0;
        return wrong;
    };
    for (std::uint32_t step = day.first + 1; step < end; ++step) {
        if (shaded[step] == shaded[step - 1]) continue;
        std::uint32_t back = step;
        while (back > day.first && isCorrected(back - 1)) --back;
        while (step < end && isCorrected(step)) ++step;
    }
}

}  // namespace noonmark
