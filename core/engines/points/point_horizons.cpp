#include "core/engines/points/point_horizons.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>

#include "core/base/progress.h"
#include "core/describe/text.h"
#include "core/engines/common/open_below.h"
#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/engines/points/horizons/point_runs.h"

namespace noonmark {

namespace {

/// What decides runs, for all threads.
struct DecidingRays {
    RayScene scene;
    std::vector<OpenBelow> open;
};

Result<DecidingRays> prepareRays(const City& city, const std::optional<RayScene>& ready,
                                 const std::stop_token& stop) {
    const auto scene = ready ? Result<RayScene>(*ready) : RayScene::over(city, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    return DecidingRays{*scene, findOpenBelow(city, all)};
}

/// The horizons of one thread's points, and the rays that decide their runs.
class PointSweep {
public:
    PointSweep(const HorizonScene& scene, const std::optional<DecidingRays>& rays, const SunSteps& sun)
        : horizon_(scene), rays_(rays), sun_(sun) {
        if (rays) search_.emplace(*scene.track);
    }

    [[nodiscard]] SunBins::Months sweep(glm::vec3 position, glm::vec3 normal) {
        if (rays_)
            horizon_.sweepWithBounds(position, normal, rays_->open);
        else
            horizon_.sweep(position, normal);
        return horizon_.countSunlit();
    }

    /// Of the point that was swept last. Adds to the number of rays.
    [[nodiscard]] PointRuns runs(glm::vec3 position, glm::vec3 normal, std::atomic<std::uint64_t>& rays) {
        if (!rays_) return horizon_.countRuns();
        const PointRunRays own(rays_->scene, sun_, position, normal);
        const PointRuns runs = search_->decide(horizon_.horizon(), horizon_.bounds(), own);
        rays += own.rays();
        return runs;
    }

private:
    HorizonOfPoint horizon_;
    const std::optional<DecidingRays>& rays_;
    const SunSteps& sun_;
    std::optional<PointRunSearch> search_;
};

}  // namespace

Result<PointMonths> sweepPoints(const City& city, const SurfacePoints& points, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop,
                                const PointSweepSettings& settings) {
    if (points.positions.size() != points.normals.size())
        return failure(
            fmt::format("{} places have {} normals", points.positions.size(), points.normals.size()),
            "surface points", "Give each place the direction that its surface faces");
    PointMonths result;
    result.possibleMin = sun.sunlitMinutes();
    result.sunlitMin.resize(points.size());
    const Stopwatch build;
    const HorizonScene scene(city, sun, settings.runs);
    if (settings.runs)
        result.longestShadowMin.resize(points.size()), result.longestSunMin.resize(points.size());
    std::optional<DecidingRays> deciding;
    if (settings.runs && settings.decidesRuns) {
        auto made = prepareRays(city, settings.scene, stop);
        if (!made) return tl::make_unexpected(made.error());
        deciding = *std::move(made);
    }
    result.cost.seconds["build"] = build.seconds();
    const Stopwatch watch;
    std::atomic<std::size_t> done{0};
    std::atomic<std::uint64_t> rays{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 64), [&](const auto& range) {
        PointSweep sweep(scene, deciding, sun);
        for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i) {
            const SunBins::Months months = sweep.sweep(points.positions[i], points.normals[i]);
            for (std::size_t month = 0; month < 12; ++month)
                result.sunlitMin[i][month] = float(double(months[month]) * sun.stepMinutes);
            if (!settings.runs) continue;
            const PointRuns runs = sweep.runs(points.positions[i], points.normals[i], rays);
            result.longestShadowMin[i] = float(runs.shadow * sun.stepMinutes);
            result.longestSunMin[i] = float(runs.sun * sun.stepMinutes);
        }
        progress.report(double(done += range.size()) / double(points.size()),
                        NM_TEXT("sweeping horizons of points"));
    });
    if (stop.stop_requested()) return cancelled();
    result.cost.seconds["sweep"] = watch.seconds();
    result.cost.rays = rays;
    result.cost.buildingsUsed = std::uint32_t(city.buildings.size());
    return result;
}

}  // namespace noonmark
