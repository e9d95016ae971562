#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/engines/points/point_horizons.h"
#include "core/engines/points/skyline.h"
#include "core/engines/ray/ray_scene.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Whether a point is in shadow at each step: 1 in shadow, 0 lit; one entry a step.
using ShadedSteps = std::vector<std::uint8_t>;

/// The shaded steps from the skyline: exact but for rounding. Some 60 ns a step.
ShadedSteps findShadedSteps(const Skyline& skyline, const SunSteps& sun);

/// The same from the rays of SurfaceRays, which the skyline is measured against. Some 0.1 us a step.
ShadedSteps traceShadedSteps(const RayScene& scene, const SkyPoint& point, const SunSteps& sun);

/// A time without a break.
struct SunBand {
    Instant from, to;
    [[nodiscard]] double minutes() const {
        return std::chrono::duration<double, std::ratio<60>>(to - from).count();
    }
    bool operator==(const SunBand&) const = default;
};

/// The times of one day (index in SunSteps::days) in which the point is lit. A step stands for `stepMinutes`
/// from its beginning.
std::vector<SunBand> findSunBands(const ShadedSteps& shaded, const SunSteps& sun, std::size_t day);

/// Moves the ends of the bands from the beginnings of steps to where `isLit` changes within the step, to 0.1
/// s. `isLit` agrees with the steps at their beginnings. Ends where it does not change, as at the end of the
/// hours, stay.
void refineSunBands(std::vector<SunBand>& bands, double stepMinutes,
                    const std::function<bool(Instant)>& isLit);

/// Gross and continuous shadow, as SurfaceShadow states them.
struct PointShadow {
    double grossMin = 0;       ///< per day, mean over the days
    double continuousMin = 0;  ///< longest unbroken run on any day
};
PointShadow countShadow(const ShadedSteps& shaded, const SunSteps& sun);

/// Minutes by month and by hour of the wall clock, summed over the days.
using MonthHours = std::array<std::array<double, 24>, 12>;
/// The sunlit minutes of these steps. `zone`: the clock; months are those of SunDay::date.
MonthHours sumSunlight(const ShadedSteps& shaded, const SunSteps& sun, const Zone& zone);
/// The same where a step counts only a share of it, 0 to 1.
MonthHours sumSunlight(const std::vector<float>& shares, const SunSteps& sun, const Zone& zone);
std::array<double, 12> sumMonths(const MonthHours& hours);

/// Finds at which steps single points of a city are in shadow. By horizons: the sweep of point_horizons.h
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

    /// Costs, by horizons, some 0.1 ms a point in Midtown, and a few ns a step.
    [[nodiscard]] ShadedSteps find(const SkyPoint& point) const;
    /// The same by rays, also where this finder was made for horizons.
    [[nodiscard]] ShadedSteps trace(const SkyPoint& point) const {
        return traceShadedSteps(rays_, point, *sun_);
    }
    /// From now on find() is by rays.
    void switchToRays() { horizons_.reset(); }

private:
    ShadedStepFinder(RayScene rays, const SunSteps& sun) : rays_(std::move(rays)), sun_(&sun) {}
    void correctDay(const SunDay& day, glm::vec3 origin, glm::vec3 normal, ShadedSteps& shaded) const;

    RayScene rays_;
    const SunSteps* sun_;
    std::shared_ptr<const HorizonScene> horizons_;  // null: by rays
};

/// The sunlight of points with trees, on top of that of the same points and steps without them. At each step
/// that nothing solid darkens, a crown takes 1 - exp(-path x optical depth of a metre), with the exact length
/// of the path; suns within half a degree of each other, which is the sun's own width, count as one. Points
/// that no crown can shade stay as they are and cost nothing; the others as ShadedStepFinder::find(), and
/// some 10 ns for each crown near the azimuth of each half degree of the sun's paths. Uses all cores;
/// cancelled() soon after a stop request. None where no tree reaches a point, and for TreeColumns::without.
Result<std::optional<ShadedPoints>> shadeTreesAtPoints(const City& city, const SurfacePoints& points,
                                                       const SunSteps& sun, const PointMonths& without,
                                                       TreeColumns columns, ShadedStepFinder::By by,
                                                       Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
