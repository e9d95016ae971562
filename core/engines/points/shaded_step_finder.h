#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/base/result.h"
#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/engines/points/point_sunlight.h"

namespace noonmark {

/// Tells at which steps single points of a city are in shadow. By horizons: the sweep of point_horizons.h
/// finds the times in the sun, and rays correct their ends: beside each change from sun to shadow, steps are
/// traced until ray and horizon agree. What is left of the sweep's error are times in sun or shadow that are
/// shorter than the sun takes through a bin (a minute in middle latitudes) and begin and end in one. By rays:
/// every step is traced. Safe to use from many threads.
class ShadedStepFinder {
public:
    enum class By { horizons, rays };

    /// `sun` must outlive it. O(n log n) in edges and steps: some 0.2 s for Midtown. Error: cancelled().
    static Result<ShadedStepFinder> over(const City& city, const SunSteps& sun, By by,
                                         const std::stop_token& stop = {});

    /// By horizons some 0.1 ms a point in Midtown, and a few ns a step.
    [[nodiscard]] ShadedSteps find(const SkyPoint& point) const;
    /// By rays, whatever it was made for.
    [[nodiscard]] ShadedSteps trace(const SkyPoint& point) const {
        return traceShadedSteps(rays_, point, *sun_);
    }
    /// From now on find() is by rays.
    void goOnByRays() { horizons_.reset(); }

private:
    ShadedStepFinder(RayScene rays, const SunSteps& sun) : rays_(std::move(rays)), sun_(&sun) {}
    void correctDay(const SunDay& day, glm::vec3 origin, glm::vec3 normal, ShadedSteps& shaded) const;

    RayScene rays_;
    const SunSteps* sun_;
    std::shared_ptr<const HorizonScene> horizons_;  // null: by rays
};

}  // namespace noonmark
