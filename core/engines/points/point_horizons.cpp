#include "core/engines/points/point_horizons.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "core/base/stopwatch.h"
#include "core/engines/points/horizons/horizon_of_point.h"

namespace noonmark {

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
    result.cost.seconds["build"] = build.seconds();
    const Stopwatch sweep;
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 64), [&](const auto& range) {
        HorizonOfPoint horizon(scene);
        for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i) {
            horizon.sweep(points.positions[i], points.normals[i]);
            const SunBins::Months months = horizon.countSunlit();
            for (std::size_t month = 0; month < 12; ++month)
                result.sunlitMin[i][month] = float(double(months[month]) * sun.stepMinutes);
            if (!settings.runs) continue;
            const PointRuns runs = horizon.countRuns();
            result.longestShadowMin[i] = float(runs.shadow * sun.stepMinutes);
            result.longestSunMin[i] = float(runs.sun * sun.stepMinutes);
        }
        progress.report(double(done += range.size()) / double(points.size()), "sweeping horizons of points");
    });
    if (stop.stop_requested()) return cancelled();
    result.cost.seconds["sweep"] = sweep.seconds();
    result.cost.buildingsUsed = std::uint32_t(city.buildings.size());
    return result;
}

}  // namespace noonmark
