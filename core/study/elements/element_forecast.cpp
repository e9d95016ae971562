#include "core/study/elements/element_forecast.h"

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/study/elements/element_sample.h"

namespace noonmark {

namespace {

constexpr std::size_t sweptProbes = 256;  // enough for all cores: the sweep takes 64 points at a time
constexpr std::size_t tracedProbes = 16;

/// The time of work that has a part of its own and one for each point.
struct PointCost {
    double once = 0, each = 0;
    [[nodiscard]] double of(std::size_t points) const { return once + double(points) * each; }
};

PointCost costOf(const PointMonths& probe, const char* stage, std::size_t points) {
    return {probe.cost.seconds.at("build"),
            probe.cost.seconds.at(stage) / double(std::max<std::size_t>(points, 1))};
}

SurfacePoints chooseProbes(const SurfacePoints& all, std::size_t count) {
    return pointsAt(all, choosePoints(all.size(), count, 0));
}

}  // namespace

Result<ElementForecast> forecastElementStudy(const City& city, const StudySettings& settings,
                                             const ElementSettings& elements, Progress& progress,
                                             const std::stop_token& stop) {
    const Stopwatch watch;
    const auto placed = placeElements(city, settings, elements, progress, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    const auto sun = computeDaylightSteps(settings.period, makeObserver(city, settings), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const auto scene = RayScene::over(city, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    const double prepared = watch.seconds();
    const SurfacePoints& all = placed->receivers.points;
    const SurfacePoints swept = chooseProbes(all, sweptProbes), traced = chooseProbes(all, tracedProbes);
    const auto horizons = sweepPoints(city, swept, *sun, progress, stop, {.runs = true, .scene = *scene});
    if (!horizons) return tl::make_unexpected(horizons.error());
    const auto rays = tracePoints(city, traced, *sun, progress, stop, *scene);
    if (!rays) return tl::make_unexpected(rays.error());
    const PointCost ofSweep = costOf(*horizons, "sweep", swept.size());
    const PointCost ofRays = costOf(*rays, "trace", traced.size());
    const std::size_t sample = std::min(all.size(), sampleSize(settings.errorSample, sun->steps.size()));
    return ElementForecast{all.size(), sun->steps.size(),
                           prepared + ofSweep.of(all.size()) + (sample > 0 ? ofRays.of(sample) : 0),
                           prepared + ofRays.of(all.size())};
}

}  // namespace noonmark
