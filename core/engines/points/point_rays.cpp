#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>

#include "core/base/stopwatch.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/points/point_horizons.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/ray/surface_rays.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

/// What rays of all points share.
struct TraceScene {
    RayScene scene;
    std::vector<SunPacket> packets;
    std::vector<std::uint8_t> monthOfStep;  // 0 to 11
    double stepMinutes;
};

std::vector<std::uint8_t> monthsOfSteps(const SunSteps& sun) {
    std::vector<std::uint8_t> months(sun.steps.size());
    for (const SunDay& day : sun.days)
        std::fill_n(months.begin() + day.first, day.count, std::uint8_t(unsigned(day.date.month()) - 1));
    return months;
}

std::uint32_t turnedAway(glm::vec3 normal, const DirectionPacket& sun) {
    std::uint32_t away = 0;
    for (int lane = 0; lane < sun.count; ++lane) {
        const auto k = std::size_t(lane);
        if (normal.x * sun.x[k] + normal.y * sun.y[k] + normal.z * sun.z[k] <= 0)
            away |= 1U << unsigned(lane);
    }
    return away;
}

// Returns the number of rays.
std::uint64_t tracePoint(const TraceScene& trace, glm::vec3 position, glm::vec3 normal, std::size_t point,
                         PointMonths& result) {
    const glm::vec3 origin = placeSurfaceRayOrigin(position, normal);
    std::array<std::uint32_t, 12> months{};
    RunCounter shadow, sun;
    std::uint64_t rays = 0;
    std::size_t step = 0;
    for (const SunPacket& packet : trace.packets) {
        const int count = packet.directions.count;
        const auto all = std::uint32_t((1ULL << unsigned(count)) - 1);
        const std::uint32_t away = turnedAway(normal, packet.directions);
        std::uint32_t blocked = 0;
        if (away != all) trace.scene.blockedLanes({&origin, 1}, packet.directions, {&blocked, 1});
        if (away != all) rays += std::uint64_t(count);
        const std::uint32_t lit = ~(blocked | away) & all;
        shadow.add(all & ~lit, packet.starts, count);
        sun.add(lit, packet.starts, count);
        for (int lane = 0; lane < count; ++lane, ++step)
            months[trace.monthOfStep[step]] += lit >> unsigned(lane) & 1U;
    }
    for (std::size_t month = 0; month < 12; ++month)
        result.sunlitMin[point][month] = float(months[month] * trace.stepMinutes);
    result.longestShadowMin[point] = float(shadow.longest() * trace.stepMinutes);
    result.longestSunMin[point] = float(sun.longest() * trace.stepMinutes);
    return rays;
}

}  // namespace

Result<PointMonths> tracePoints(const City& city, const SurfacePoints& points, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop,
                                std::optional<RayScene> scene) {
    if (points.positions.size() != points.normals.size())
        return failure(
            fmt::format("{} places have {} normals", points.positions.size(), points.normals.size()),
            "surface points", "Give each place the direction that its surface faces");
    const Stopwatch build;
    if (!scene) {
        auto made = RayScene::over(city, stop);
        if (!made) return tl::make_unexpected(made.error());
        scene = *std::move(made);
    }
    const TraceScene trace{*std::move(scene), packSteps(sun), monthsOfSteps(sun), sun.stepMinutes};
    PointMonths result;
    result.possibleMin = sun.sunlitMinutes();
    result.sunlitMin.resize(points.size());
    result.longestShadowMin.resize(points.size());
    result.longestSunMin.resize(points.size());
    result.cost.seconds["build"] = build.seconds();
    const Stopwatch watch;
    std::atomic<std::size_t> done{0};
    std::atomic<std::uint64_t> rays{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 4), [&](const auto& range) {
        const FlushDenormals flush;
        for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
            rays += tracePoint(trace, points.positions[i], points.normals[i], i, result);
        progress.report(double(done += range.size()) / double(points.size()), "tracing rays from points");
    });
    if (stop.stop_requested()) return cancelled();
    result.cost.seconds["trace"] = watch.seconds();
    result.cost.rays = rays;
    result.cost.buildingsUsed = std::uint32_t(city.buildings.size());
    return result;
}

}  // namespace noonmark
