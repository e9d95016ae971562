#include "core/study/glazing/glazing_sample.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace noonmark {

namespace {

std::size_t countDifferent(const ShadedSteps& one, const ShadedSteps& other) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < one.size(); ++i) different += one[i] != other[i] ? 1 : 0;
    return different;
}

}  // namespace

GlazingSample sampleGlazing(const GlazingScene& scene, const std::stop_token& stop) {
    constexpr std::size_t maxSampled = 64;
    const SurfacePoints& points = scene.placed.receivers.points;
    const std::size_t count = std::min(points.size(), maxSampled);
    std::atomic<std::size_t> different{0};
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const std::size_t window = i * points.size() / count;
        const SkyPoint point{points.positions[window], points.normals[window]};
        different += countDifferent(scene.after->find(point), scene.after->trace(point));
    });
    const double steps = double(count) * double(scene.days.sun.steps.size());
    return {count, steps > 0 ? 100 * double(different) / steps : 0};
}

std::string describe(const GlazingSample& sample) {
    return fmt::format("horizons of {} windows are off by {:.3f} % of the steps", sample.windows,
                       sample.offPct);
}

}  // namespace noonmark
